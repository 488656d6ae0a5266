/// @file The optimized contact of a scene, cycle after cycle.
#pragma once

#include <memory>
#include <stdexcept>

#include "optimized/contact.h"
#include "verification/performance/bench/bench_scene.h"
#include "verification/performance/bench/timing.h"

namespace type21::bench {

class ContactRun {
  public:
    explicit ContactRun(const BenchScene& scene, const optimized::ContactOptions& options = {})
        : scene_(scene),
          options_(options),
          contact_(std::make_unique<optimized::Contact>(scene.scene, scene.interface, options)) {}

    /// Times the next cycle [ns per node]; a recorded motion that has ended begins again with a new contact.
    /// @param lean  the step that the time integration needs; where the scene has no such step, the full one
    double next(bool lean, bool one_thread = true) {
        if (scene_.cycles > 0 && cycle_ >= scene_.cycles) {
            contact_ = std::make_unique<optimized::Contact>(scene_.scene, scene_.interface, options_);
            cycle_ = 0;
        }
        const Motion motion = scene_.motion(cycle_++);
        const Watch watch(one_thread);
        if (lean && has_lean_) {
            try {
                contact_->step_lean(motion);
                return watch.nanoseconds() / static_cast<double>(scene_.nodes());
            } catch (const std::logic_error&) {
                has_lean_ = false;
            }
        }
        contact_->step_into(motion, step_);
        keep(step_);
        return watch.nanoseconds() / static_cast<double>(scene_.nodes());
    }
    /// Runs a generated scene until the contact has set up what it sets up once.
    void settle() {
        for (int c = 0; c < settling_cycles && scene_.cycles == 0; ++c)
            next(true);
    }
    int cycle() const { return cycle_; }
    bool has_lean() const { return has_lean_; }
    optimized::Contact& contact() { return *contact_; }

  private:
    const BenchScene& scene_;
    optimized::ContactOptions options_;
    std::unique_ptr<optimized::Contact> contact_;
    ContactStep step_;  ///< its memory is used again, as the host does
    int cycle_ = 0;
    bool has_lean_ = true;
};

}  // namespace type21::bench
