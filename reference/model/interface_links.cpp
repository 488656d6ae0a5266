/// @file Look-ups by id.
#include "reference/model/interface_links.h"

#include <fmt/format.h>

#include "reference/model/friction_rules.h"
#include "reference/model/heat_rules.h"

namespace type21 {
namespace {

/// Index of the object with this id, -1 if there is none.
template <class Object>
int index_of(const std::vector<Object>& objects, Id id) {
    for (size_t index = 0; index < objects.size(); ++index)
        if (objects[index].id == id) return static_cast<int>(index);
    return -1;
}

int surface(const CardValidator& validator, std::string_view field, Id id) {
    if (id == 0) {
        validator.error(field, "names the surface and must be given", "Give the id of a /SURF");
        return -1;
    }
    const int found = index_of(validator.model.surfaces, id);
    if (found < 0) {
        validator.error(field, fmt::format("there is no surface {}", id), "Give the id of a /SURF of the deck");
    } else if (validator.model.surfaces[static_cast<size_t>(found)].segments.empty()) {
        validator.error(field, "the surface has no segments",
                        "Check the parts, surfaces or segments that it is made of");
    }
    return found;
}

template <class Object>
int optional_link(const CardValidator& validator, std::string_view field, Id id, const std::vector<Object>& objects,
                  std::string_view keyword) {
    if (id == 0) return -1;
    const int found = index_of(objects, id);
    if (found < 0)
        validator.error(field, fmt::format("there is no {} with this id", keyword),
                        fmt::format("Give the id of a {} of the deck, or 0", keyword));
    return found;
}

}  // namespace

/// @manual field Ithe, fct_IDK, Fcond
void link_interface(const CardValidator& validator) {
    Interface& it = validator.interface;
    it.secondary_surface = surface(validator, "surf_IDs", it.surf_secondary);
    it.main_surface = surface(validator, "surf_IDm", it.surf_main);
    it.sensor = optional_link(validator, "sens_ID", it.sens_id, validator.model.sensors, "/SENSOR");
    it.friction_model = optional_link(validator, "fric_ID", it.fric_id, validator.model.friction_models, "/FRICTION");
    if (uses_friction_function(it))
        it.function_friction = optional_link(validator, "fct_IDF", it.fct_idf, validator.model.functions, "/FUNCT");
    if (it.ithe != 0) {
        it.function_conduction = optional_link(validator, "fct_IDK", it.fct_idk, validator.model.functions, "/FUNCT");
        it.function_distance = optional_link(validator, "Fcond", it.fcond, validator.model.functions, "/FUNCT");
        check_distance_function(validator);
    }
    it.tool = index_of(validator.model.rigid_bodies, it.idrby);
    if (it.tool < 0)
        validator.error(
            "IDrby",
            it.idrby == 0 ? "names the tool's rigid body and must be given" : "there is no /RBODY with this id",
            "Give the id of the /RBODY that holds every main node");
}

/// @manual field IDref
void link_reference_interface(const CardValidator& validator) {
    Interface& it = validator.interface;
    if (it.idref == 0) return;
    const int found = index_of(validator.model.interfaces, it.idref);
    if (found < 0) {
        validator.error("IDref", "there is no /INTER/TYPE21 with this id",
                        "Give the id of another TYPE21 interface, or 0 for absolute damping");
    } else if (it.idref == it.id) {
        validator.error("IDref", "an interface is not its own reference",
                        "Give the id of another TYPE21 interface, or 0 for absolute damping");
    } else {
        it.reference_interface = found;
    }
}

}  // namespace type21
