/// @file The scene in which effects are measured: a structured sheet on a gently curved tool that slides below it.
#pragma once

#include <functional>
#include <vector>

#include "verification/support/prescribed_motion.h"
#include "verification/support/scene_builder.h"

namespace type21::accuracy {

/// Each node of the sheet penetrates the tool by 0.1 mm, so that each is in contact in each cycle. Mg, mm, s.
class EffectScene {
  public:
    /// @param nodes   along each side of the sheet
    /// @param change  made to the card before the effects are planned
    EffectScene(int nodes, const std::function<void(Interface& card)>& change);

    const HostScene& scene() const { return scene_; }
    /// In each cycle the tool moves by 2 um. The sheet is 2 % thicker than at time 0 from the start. The spans live as
    /// long as the scene.
    Motion motion(int cycle) const;

  private:
    HostScene scene_;
    SlidingTool tool_;
    std::vector<double> thickness_, temperature_;
};

}  // namespace type21::accuracy
