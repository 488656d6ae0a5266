/// @file The long runs: each a scene, a number of cycles, and numbers that must keep their bounds. A scheme has errors,
/// but they must not grow with time faster than theory says.
#pragma once

#include <string_view>
#include <vector>

#include "reference/host/march.h"
#include "verification/stability/finding.h"

namespace type21::stability {

struct LongRunKind {
    std::string_view name;
    long cycles;  ///< default number
    LongRun (*run)(const MakeContact& make_contact, long cycles);
};

/// In the order in which they are shown.
const std::vector<LongRunKind>& long_runs();

/// A node is moved in a circle over the fold between two planes of 30 degrees slope; the path is closed and repeats its
/// bits.
LongRun circling(const MakeContact& make_contact, long cycles, bool convex);

/// The tool with the fold turns under a held node: the same circle, but the pose is accumulated step by step.
LongRun turning(const MakeContact& make_contact, long cycles);

/// A node under constant load bounces on a flat tool.
/// @param viss  VISs: 0 undamped
LongRun bouncing(const MakeContact& make_contact, long cycles, double viss);

/// Four nodes rest on a flat tool under a normal and a tangential load.
/// @param share  of the friction limit that the tangential load takes [-]
LongRun resting(const MakeContact& make_contact, long cycles, double share);

}  // namespace type21::stability
