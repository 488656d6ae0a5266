/// @file Motions that are given, for a contact that is stepped without a host.
#pragma once

#include <memory>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

/// One node whose position and velocity are given in each cycle. Its tool stands still.
class PrescribedNode {
  public:
    /// @param scene  its first interface and that interface's first secondary node are used
    PrescribedNode(const Scene& scene, const MakeContact& make_contact);
    /// One cycle of length `step` [time] that ends at x [length], reached with velocity v [velocity]. The first call is
    /// time 0.
    NodeContact to(const Vec3& x, const Vec3& v, double step);

  private:
    Scene scene_;
    std::unique_ptr<ContactMethod> contact_;
    std::vector<Vec3> position_, velocity_;
    double time_ = 0;
    bool begun_ = false;
};

/// The only tool of a scene slides at constant speed, without turning, under nodes that stand still.
class SlidingTool {
  public:
    /// @param direction  of the motion, of unit length [-]
    /// @param travel     in one cycle [length]
    /// @param step       of time in one cycle [time]
    SlidingTool(std::shared_ptr<const ContactModel> model, const Vec3& direction, double travel, double step);
    /// The motion of a cycle, from 0. Its spans live as long as this object.
    Motion at(int cycle) const;

  private:
    std::shared_ptr<const ContactModel> model_;
    std::vector<Vec3> velocity_;
    Vec3 direction_;
    double travel_, step_;
};

}  // namespace type21
