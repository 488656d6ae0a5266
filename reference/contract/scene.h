/// @file The Scene: what a contact computes on, and which effects each interface asks for.
#pragma once

#include <memory>
#include <vector>

#include "departures.h"
#include "effects.h"
#include "friction_model.h"
#include "function.h"
#include "interface.h"
#include "mesh.h"
#include "rigid_body.h"

namespace type21 {

/// What a contact may know of its scene: resolved, in one consistent system of units, constant for a run. Plain data:
/// a deck fills it (reference/model), and so may any program. Indices are into these vectors, from 0.
struct ContactModel {
    AsBuilt as_built;  ///< departures that are switched on; none by default

    Nodes nodes;                      ///< of blank and tools, ids ascending
    std::vector<Material> materials;  ///< only heat conduction into the blank reads them
    std::vector<Part> parts;
    std::vector<Shell> shells;
    std::vector<Surface> surfaces;  ///< secondary and main surfaces of the interfaces
    std::vector<Function> functions;
    std::vector<RigidBody> rigid_bodies;  ///< the tools; Motion::tools has one pose for each
    std::vector<FrictionModel> friction_models;
    std::vector<Interface> interfaces;
};

/// The model and the effects that each of its interfaces asks for. An effect that is not listed holds no state and
/// costs no time. Copies share the model.
struct Scene {
    std::shared_ptr<const ContactModel> model;
    std::vector<std::vector<Effect>> effects;  ///< one list per interface, in the order of the enum

    /// @throws std::out_of_range when there is no such interface
    bool has(int interface, Effect effect) const;
};

/// The effects that the resolved fields of an interface ask for, in the order of the enum.
std::vector<Effect> effects_of(const ContactModel& model, const Interface& interface);

/// The scene of a resolved model: every interface with its effects_of().
/// @param model  must not be null
Scene scene_of(std::shared_ptr<const ContactModel> model);

/// fct_IDF scales Fric: only in law 0 of the card.  Formulation 8, step 3; manual page, comment 12.
bool uses_friction_function(const Interface& interface);

/// The friction coefficient of some node can be above 0.
/// @throws std::out_of_range when fric_ID of the interface is an index of no friction model
bool has_friction(const ContactModel& model, const Interface& interface);

/// The tangential force is filtered: Ifiltr with Xfreq, of the card or of /FRICTION (D28: either).
bool filters_friction(const ContactModel& model, const Interface& interface);

}  // namespace type21
