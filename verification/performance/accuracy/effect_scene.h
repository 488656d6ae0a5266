/// @file The scene in which effects are measured: a structured sheet on a gently curved tool that slides below it.
#pragma once

#include <vector>

#include "reference/contract/motion.h"
#include "reference/model/host_scene.h"

namespace type21::accuracy {

/// Nodes of the sheet follow the tool at 0.1 mm inside the gap, so that each is in contact in each cycle. Mg, mm, s.
class EffectScene {
  public:
    /// @param nodes   along each side of the sheet
    /// @param change  made to the card before the effects are planned
    template <class Change>
    EffectScene(int nodes, const Change& change) : EffectScene(nodes) {
        Model model = *scene_.host;
        change(model.interfaces[0]);
        scene_ = plan(std::make_shared<const Model>(std::move(model)));
    }

    const HostScene& scene() const { return scene_; }
    /// Cycle by cycle the tool moves by 2 um; the sheet has thickened by 2 % from the start. The spans live as long as
    /// the scene.
    Motion motion(int cycle) const;

  private:
    explicit EffectScene(int nodes);

    HostScene scene_;
    std::vector<Vec3> velocity_;
    std::vector<double> thickness_, temperature_;
};

}  // namespace type21::accuracy
