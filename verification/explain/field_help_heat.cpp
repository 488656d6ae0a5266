/// @file Lines 9 to 12: adaptive meshing, heat, the tool and its damping.
#include "verification/explain/field_help.h"

namespace type21 {

std::vector<FieldHelp> field_help_heat() {
    using enum Departure;
    return {
        {"NRadm", "Elements wanted along a radius of 90 degrees.",
         "An element is to be divided where the tool's radius is below NRadm times its longest edge. Used with Iadm 2.",
         "page, comment 3; formulation 9", {D37}},
        {"Padm", "Penetration, as a share of the gap, above which the angle counts.", "Used with Iadm 2, with Angladm.",
         "page, comment 3; formulation 9", {}},
        {"Angladm", "Angle between tool normals above which an element is to be divided.",
         "Used with Iadm 2, with Padm. In degrees.", "page, comment 3; formulation 9", {}},
        {"Kthe", "Coefficient of heat exchange in the gap, or the factor on fct_IDK.",
         "Heat of a step A (T_m - T_s) dt / (d / k_s + 1 / K); K = 0 means no conduction.",
         "page, comment 16, equations (14) and (15); formulation 9", {D36}},
        {"fct_IDK", "Function of the contact pressure that scales Kthe.", "K = Kthe f(AscaleK |F_n| / A).",
         "page, comment 16, equation (15); formulation 9", {D36}},
        {"AscaleK", "Factor on the pressure at which fct_IDK is taken.", "Used with fct_IDK.",
         "page, definitions, equation (15); formulation 9", {}},
        {"Tint", "Temperature of the tool where it is constant.",
         "Used with Ithe 1 and Ithe_form 0, else the temperatures of the tool's nodes hold.",
         "page, comment 16; formulation 9", {D08}},
        {"Ithe_form", "Whether the tool has temperatures of its own and is heated.",
         "0: the tool has Tint. 1: heat goes between both sides, the nodes of the tool receive what the blank loses.",
         "page, comment 16; formulation 9", {D16}},
        {"Frad", "Factor of radiation, sigma / (1 / eps_1 + 1 / eps_2 - 1).",
         "Heat of a step Frad A (T_m^4 - T_s^4) dt, between the gap and Drad. 0 means no radiation.",
         "page, comment 17, equations (16) to (18); formulation 9", {D11, D15}},
        {"Drad", "Largest distance of radiation.",
         "Not used without Frad and Fcond. 0: Dcond where Fcond and Dcond are given, else the larger of the largest gap and "
         "the shortest secondary edge. A value below the largest gap of time 0 is raised to it.",
         "page, comments 17 and 24, equation (16); formulation 9", {D11, D15}},
        {"Fheat", "Share of the friction energy that becomes heat of the secondary side.",
         "Heat of a step Fheat <T - F_t, F_t> / k. Needs Ithe.", "page, comment 18, equation (19); formulation 9",
         {D04, D16}},
        {"Fcond", "Function of the distance beyond the gap that scales the conduction.",
         "K f((d - g) / (Dcond - g)) for g < d <= Dcond, K at pressure 0. Both axes from 0 to 1.",
         "page, comments 22 and 23, equation (20); formulation 9", {D14, D32}},
        {"Dcond", "Largest distance of conduction.",
         "Used with Fcond. 0: Drad. A value above Drad is lowered to it.",
         "page, comments 22 to 24, equation (20); formulation 9", {D14}},
        {"IDrby", "Rigid body of the tool; its main node is the reference of the tool frame.",
         "Must be given; all nodes of the main surface belong to it.", "page, description; formulation 1", {D24}},
        {"IDref", "Interface whose tool the damping of this tool is relative to.",
         "0: damping of the velocity itself. Otherwise of V - V_ref, and the opposite acts on the other tool.",
         "page, comment 19; formulation 9", {}},
        {"Damp", "Share of the critical damping of the tool's translation.",
         "Force -C V with C = 2 Damp sqrt(M K), K the sum of k over the nodes in contact.", "page, comment 19; formulation 9",
         {D13}},
        {"Dampr", "Share of the critical damping of the tool's rotation.",
         "Torque -C W with C = 2 Dampr sqrt(I K), K the sum of k |X - x_G|^2. No effect where the rotations are fixed.",
         "page, comment 19; formulation 9", {D13}},
    };
}

}  // namespace type21
