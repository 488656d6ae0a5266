/// @file One /INTER/TYPE21 with every default resolved, each value with its origin.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "effects.h"
#include "mesh.h"
#include "origin.h"

namespace type21 {

/// The nodes of the secondary surface and what the interface needs to know of each; one entry a node, ascending by node
/// id. Filled at time 0.  Formulation 2, step 1; Formulation 7, step 1.
struct SecondarySide {
    std::vector<int> node;                  ///< index into ContactModel::nodes
    std::vector<double> thickness;          ///< t0: largest thickness of the shells at the node [length]
    std::vector<double> contact_thickness;  ///< t_c: contact thickness of the node's part, 0 = none [length]
    std::vector<double> gap;                ///< g0: gap at time 0, between Gapmin and Gapmax [length]
    std::vector<double> search_gap;         ///< gap that decides contact; g0 but for D33 [length]
    std::vector<double> area;  ///< A: quarter of each quad, third of each triangle of the surface [length^2]
    std::vector<double> element_stiffness;  ///< S: mean of E t over the shells at the node [force/length]
    std::vector<double> mass;               ///< m: lumped mass of the node, added masses too [mass]

    int size() const { return static_cast<int>(node.size()); }
};

/// Names follow the manual page; integers are flags, reals are in the work units of the model.
///
/// A field that is not given has the default of the card, so that an Interface may also be filled by hand. What no
/// default can know must be given then: the two surfaces, the tool, Gapmin or the gaps of `secondary`, DEPTH,
/// `main_nodes`, `largest_gap`, and the areas, stiffnesses and masses of `secondary` that its effects read. A link
/// (`sensor`, `function_friction`, ...) is given together with the id of the field that it belongs to (`sens_id`,
/// `fct_idf`, ...).
struct Interface {
    Id id = 0;
    std::string title;
    std::string file;
    int line = 0;  ///< of the keyword

    int secondary_surface = -1;  ///< index into ContactModel::surfaces
    int main_surface = -1;
    int tool = -1;                 ///< IDrby: index into ContactModel::rigid_bodies
    int reference_interface = -1;  ///< IDref: index into ContactModel::interfaces, -1: none
    int sensor = -1;               ///< sens_ID: index into ContactModel::sensors, -1: none
    int friction_model = -1;       ///< fric_ID: index into ContactModel::friction_models, -1: none
    int function_friction = -1;    ///< fct_IDF: index into ContactModel::functions
    int function_conduction = -1;  ///< fct_IDK
    int function_distance = -1;    ///< Fcond

    // line 1
    Sourced<Id> surf_secondary, surf_main;
    Sourced<int> istf, ithe, igap, idel, invn, iadm;
    // line 2
    Sourced<double> fscalegap{1.0}, gapmax{no_limit};
    Sourced<double> depth;  ///< [length]; a deck takes 0 for the larger of largest_gap and shortest_edge
    Sourced<double> pmax{no_limit};
    Sourced<int> itlim;
    // line 3
    Sourced<double> stmin, stmax{no_limit}, pskid{no_limit};
    // line 4
    Sourced<double> stfac{1.0}, fric, gapmin, tstart, tstop{no_limit};
    // line 5
    Sourced<int> ibc;  ///< 4 x + 2 y + z
    Sourced<int> inacti;
    Sourced<double> viss{1.0}, bumult{0.20};
    // line 6
    Sourced<int> ifric, ifiltr;
    Sourced<double> xfreq;
    int card_ifiltr = 0;  ///< as the card has them, also where /FRICTION replaces them (D28)
    double card_xfreq = 0;
    Sourced<Id> sens_id, fct_idf;
    Sourced<double> ascalef{1.0};
    Sourced<Id> fric_id;
    // lines 7, 8
    std::array<Sourced<double>, 6> c;
    // line 9
    Sourced<int> nradm{3};  ///< read with Iadm 2 only
    Sourced<double> padm{1.0}, angladm;
    // line 10
    Sourced<double> kthe;
    Sourced<Id> fct_idk;
    Sourced<double> ascalek{1.0}, tint;
    Sourced<int> ithe_form;
    // line 11
    Sourced<double> frad, drad, fheat;
    Sourced<Id> fcond;
    Sourced<double> dcond;
    // line 12
    Sourced<Id> idrby, idref;
    Sourced<double> damp, dampr;

    SecondarySide secondary;
    std::vector<int> main_nodes;  ///< index into ContactModel::nodes, ascending
    double largest_gap = 0;       ///< G: largest g0 of the secondary nodes [length]
    double smallest_gap_raw = 0;  ///< smallest g_s before Gapmin and Gapmax act, for the kinematic step [length]
    double shortest_edge = 0;     ///< of the secondary surface [length]
    bool tool_rotates = true;     ///< false when the three rotations of the main node are fixed by /BCS
};

}  // namespace type21
