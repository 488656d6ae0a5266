/// @file The HostScene: the scene of the contact, and the model that drives it.
#pragma once

#include <memory>
#include <utility>

#include "reference/contract/scene.h"
#include "reference/model/model.h"

namespace type21 {

/// What a run needs. A contact is given the Scene alone; loads, boundary conditions, steps and histories are the
/// host's.
struct HostScene : Scene {
    std::shared_ptr<const Model> host;  ///< the same object as Scene::model
};

/// The scene of a resolved deck.
inline HostScene plan(std::shared_ptr<const Model> model) {
    HostScene scene{scene_of(model), nullptr};
    scene.host = std::move(model);
    return scene;
}

}  // namespace type21
