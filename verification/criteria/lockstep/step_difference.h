/// @file Compares one cycle of one interface between two implementations.
#pragma once

#include "verification/criteria/lockstep/lockstep.h"

namespace type21 {

/// Adds the comparison of one cycle to a result.
class StepDifference {
  public:
    StepDifference(const Interface& card, const ContactModel& model, LockstepResult& result)
        : card_(card), model_(model), result_(result) {}

    void add(const ContactStep& reference, const ContactStep& other, const Motion& motion, long cycle);

  private:
    struct Scales;
    void node(size_t i, const ContactStep& reference_step, const ContactStep& other_step, const Motion& motion,
              Scales& sum);
    void skid(size_t i, double apart, double force_scale);
    void sums(const ContactStep& reference, const ContactStep& other, const Scales& scale);
    void lists(const ContactStep& reference, const ContactStep& other);
    void add_sum(const char* which, double difference, double scale);
    void tally(int quantity, double difference, double scale, const char* which = "");
    void decision_differs(const std::string& what);

    const Interface& card_;
    const ContactModel& model_;
    LockstepResult& result_;
    LockstepPlace place_;
    std::vector<double> noise_;       ///< largest scale of the force since each node's contact began [force]
    std::vector<double> skid_scale_;  ///< and since the start, if there is a skid line [force]
};

}  // namespace type21
