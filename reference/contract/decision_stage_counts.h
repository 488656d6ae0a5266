/// @file How many decisions each arithmetic settled, and what that cost.
#pragma once

#include <array>
#include <cstddef>

namespace type21 {

/// Counts over node decisions (one for each secondary node and cycle that looked at the tool), by Stage.
struct DecisionStageCounts {
    long nothing_near = 0;            ///< no segment's box held the node: no arithmetic
    std::array<long, 3> settled{};    ///< by the last stage that was needed
    long double_wrong = 0;            ///< that plain double arithmetic would have decided differently
    std::array<double, 3> seconds{};  ///< spent in each stage [s]

    long decisions() const { return nothing_near + settled[0] + settled[1] + settled[2]; }

    DecisionStageCounts& operator+=(const DecisionStageCounts& other) {
        nothing_near += other.nothing_near;
        double_wrong += other.double_wrong;
        for (size_t i = 0; i < settled.size(); ++i) {
            settled[i] += other.settled[i];
            seconds[i] += other.seconds[i];
        }
        return *this;
    }
};

template <class Archive>
void visit_state(Archive& archive, DecisionStageCounts& counts) {
    auto& [nothing_near, settled, double_wrong, seconds] = counts;
    archive(nothing_near, double_wrong);
    for (size_t i = 0; i < settled.size(); ++i)
        archive(settled[i], seconds[i]);
}

}  // namespace type21
