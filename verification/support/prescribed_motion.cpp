#include "verification/support/prescribed_motion.h"

#include <utility>

namespace type21 {

PrescribedNode::PrescribedNode(const Scene& scene, const MakeContact& make_contact)
    : scene_(scene),
      contact_(make_contact(scene, 0)),
      position_(scene.model->nodes.position),
      velocity_(position_.size(), Vec3::Zero()) {}

NodeContact PrescribedNode::to(const Vec3& x, const Vec3& v, double step) {
    const auto node = static_cast<size_t>(scene_.model->interfaces[0].secondary.node[0]);
    position_[node] = x;
    velocity_[node] = v;
    if (begun_) time_ += step;
    Motion motion;
    motion.time = time_;
    motion.step = motion.friction_step = begun_ ? step : 0.0;
    motion.position = position_;
    motion.velocity = velocity_;
    motion.tools.resize(1);
    motion.tools[0].position = scene_.model->rigid_bodies[0].center;
    begun_ = true;
    return contact_->step(motion).nodes.front();
}

SlidingTool::SlidingTool(std::shared_ptr<const ContactModel> model, const Vec3& direction, double travel, double step)
    : model_(std::move(model)),
      velocity_(static_cast<size_t>(model_->nodes.size()), Vec3::Zero()),
      direction_(direction),
      travel_(travel),
      step_(step) {}

Motion SlidingTool::at(int cycle) const {
    Motion motion;
    motion.time = step_ * cycle;
    motion.step = motion.friction_step = cycle == 0 ? 0 : step_;
    motion.position = model_->nodes.position;
    motion.velocity = velocity_;
    ToolMotion pose;
    pose.position = model_->rigid_bodies[0].center + direction_ * (travel_ * cycle);
    pose.velocity = direction_ * (travel_ / step_);
    motion.tools = {pose};
    return motion;
}

}  // namespace type21
