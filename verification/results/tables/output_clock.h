/// @file When a history record is due.
#pragma once

namespace type21 {

/// Records at the /TFILE interval as Radioss takes them: one when t_n reaches the next output time, which then moves on
/// in whole intervals past t_n. The first and the last cycle always give one.
class OutputClock {
  public:
    /// @param interval  [time]; 0 or not larger than the step: every cycle
    explicit OutputClock(double interval) : interval_(interval) {}

    /// Asked once a cycle, in order.
    /// @param time  t_n [time]
    /// @param step  dt1, the step that led here [time]
    bool due(double time, double step, bool last);
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(next_, first_);
    }

  private:
    double interval_;
    double next_ = 0;
    bool first_ = true;
};

}  // namespace type21
