#include "verification/lockstep/lockstep_decks.h"

namespace type21 {

std::string known_exception(const Scene& scene) {
    const Model& model = *scene.model;
    if (model.run_name == "node_on_surface" && model.as_built.has(Departure::D12))
        return "D12: at cycle 256 the nodes lie on the surface, and the direction is a difference of two points that "
               "is "
               "all rounding; the friction remembers it";
    return "";
}

}  // namespace type21
