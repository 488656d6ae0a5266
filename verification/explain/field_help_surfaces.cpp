/// @file Lines 1 to 5: surfaces, gap, stiffness, activity, initial state.
#include "verification/explain/field_help.h"

namespace type21 {

std::vector<FieldHelp> field_help_surfaces() {
    using enum Departure;
    return {
        {"surf_IDs", "Secondary surface, the blank: its nodes are those that may touch the tool.",
         "A node that is also a node of the main surface is an error.", "page, description; formulation 1", {D18}},
        {"surf_IDm",
         "Main surface, the rigid tool: its segments are what a node touches.",
         "All its nodes belong to the rigid body IDrby. Its segments look toward the blank, and each lies on an element, "
         "a void one will do.",
         "page, comment 1; formulation 1 and 4", {D18, D23, D34}},
        {"Istf", "Whether Stfac is a factor on the stiffness of the shells or the stiffness itself.",
         "0: k = Stfac S, S the mean of E t over the shells at the node, k between Stmin and Stmax. 1: k = Stfac.",
         "page, definitions; formulation 7", {D02, D04, D05}},
        {"Ithe", "Heat exchange between blank and tool.",
         "0: none, nothing thermal is computed or stored. 1: conduction, radiation, friction heat. 2: the same with the "
         "temperatures of the tool's nodes, and only the blank is heated.",
         "page, comment 16, equation (14); formulation 9", {D22}},
        {"Igap", "How the gap of a node is found.",
         "0: Gapmin everywhere. 1: half of the thickness at time 0. 2: half of the thickness of the cycle. Any other value "
         "is an error.",
         "page, comment 2, equations (1) to (4); formulation 2", {D03, D19, D27, D29, D30, D33}},
        {"Idel", "Whether a node leaves the interface with its elements.",
         "0: it stays. 1, 2: it leaves when every element at it is deleted.", "page, definitions; formulation 9", {}},
        {"Invn", "Test for main normals that look away from the blank.",
         "1: a first impact with p_g > g + 0.99 DEPTH stops the run after its cycle is recorded, with node and segment "
         "named. 0: no test.",
         "page, comment 21; formulation 7", {}},
        {"Iadm", "Data for adaptive meshing: which elements of the blank should be divided.",
         "0: none. 1: radius of the tool below the longest edge. 2: radius below NRadm times the longest edge, or "
         "normals that turn by more than Angladm under a penetration above Padm. The division itself is not done.",
         "page, comment 3; formulation 9", {D37}},
        {"Fscalegap", "Factor on the thickness in the gap.", "Used with Igap 1 and 2.",
         "page, comment 2, equations (1) to (4); formulation 2", {D30}},
        {"Gapmax", "Upper bound of the gap.", "Used with Igap 1 and 2. Where Gapmin is larger, Gapmin wins.",
         "page, comment 2; formulation 2", {D30, D33}},
        {"DEPTH", "How far behind the tool's surface a node is still pushed out.",
         "A node deeper than DEPTH has no force. A value below the largest gap of time 0 is raised to it. Read for every "
         "Igap.",
         "page, comment 4; formulation 2 and 3 (step 5)", {D03, D34}},
        {"Pmax", "Pressure at which the force of a thickening sheet stays on a plateau.",
         "Used with Igap 2. With D = g - g0 and P_A = A Pmax: F = k p while k D <= P_A, else F = k max(p - D, 0) + "
         "min(P_A, k p).",
         "page, comment 5, equations (5) and (6); formulation 7", {}},
        {"ITlim", "Whether Pmax bounds the friction force, too.",
         "0: |F_t| is at most A Pmax / sqrt(3). 1: it is not bounded by Pmax. Used with Igap 2.",
         "page, comment 5, equation (6); formulation 8", {}},
        {"Stmin", "Least stiffness of a node.", "Used with Istf 0.", "page, definitions; formulation 7", {D01}},
        {"Stmax", "Largest stiffness of a node.", "Used with Istf 0.", "page, definitions; formulation 7", {D01}},
        {"Pskid", "Pressure that the skid lines are measured by.",
         "A sliding node has the ratio |F_t| sqrt(3) / (Pskid A), at most 1; the output is its largest value since the "
         "start.",
         "page, definitions; formulation 8", {}},
        {"Stfac", "Stiffness of a node, or the factor on that of the shells.",
         "Istf 0: factor, may be larger than 1. Istf 1: the stiffness itself, 0 gives an interface without force.",
         "page, comments 6 and 11; formulation 7", {D02, D04, D05}},
        {"Fric", "Friction coefficient of Coulomb, or the constant part of laws 1, 2 and 4.",
         "With fct_IDF it is the factor on that function. Replaced by /FRICTION where fric_ID names one.",
         "page, comment 12, equations (7), (10) and (11); formulation 8", {D08}},
        {"Gapmin", "The gap with Igap 0, its lower bound with Igap 1 and 2.",
         "Igap 0 and blank: half of the mean thickness of the secondary shells. Igap 1 and 2: there is no default bound.",
         "page, comment 2; formulation 2", {D19, D30}},
        {"Tstart", "Time from which the interface acts.", "Not used where sens_ID is given.",
         "page, comment 20; formulation 9", {D09}},
        {"Tstop", "Last time at which the interface acts.", "Not used where sens_ID is given.",
         "page, comment 20; formulation 9", {D09}},
        {"IBC", "Translations of a node's boundary condition that end with its first effective penetration.",
         "Three digits for X, Y, Z in columns 8, 9, 10: 1 is released for good, 0 stays.",
         "page, comment 7; formulation 9", {}},
        {"Inacti", "What becomes of penetrations at time 0.",
         "0: full force at once. 1: the node is switched off. 3: the node is moved out to the gap. 5: P0 = p_g, no force "
         "at first. 6: P0 = p_g + 0.05 (g + DEPTH - p_g). 2 and 4 are errors.",
         "page, comments 8 and 9; formulation 6", {D20, D26, D31, D33}},
        {"VISs", "Share of the critical damping, normal to the surface.",
         "C = VISs sqrt(2 k m). It also pulls a node back that leaves.", "page, definitions; formulation 7", {}},
        {"Bumult", "Room for the search of candidates.",
         "Has no effect on a result here: the search is complete for every value.", "page, comment 10; formulation 4",
         {D23}},
    };
}

}  // namespace type21
