/// @file Reference and optimized contact side by side: the same state goes into both in every cycle, and what comes out
/// is compared. The run goes on with the reference's output.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/host/march.h"
#include "verification/criteria/lockstep/ulp_tally.h"

namespace type21 {

/// What the optimized implementation promises: 4 units in the last place of the magnitudes that enter (node_scale.h).
/// Both evaluate the same equations with a handful of roundings in another order.
inline constexpr double lockstep_ulps = 4.0;

/// The first thing that is not the same.
struct LockstepDifference {
    LockstepPlace place;
    std::string what;  ///< "decision: contact, segment 4, triangle 1, side +1; the reference: none"
};

struct LockstepResult {
    long cycles = 0;     ///< in which an interface was active
    long decisions = 0;  ///< nodes times cycles
    long in_contact = 0;
    long different = 0;  ///< decisions
    long grazing = 0;    ///< nodes whose penetration is one to one of them and rounding to the other
    long lists = 0;      ///< released nodes and inverted normals that differ
    std::vector<UlpTally> tally;
    std::optional<LockstepDifference> first_decision, first_force;

    LockstepResult();
    LockstepResult& operator+=(const LockstepResult& other);
    /// Of all quantities [ulps].
    double largest() const;
    bool same_decisions() const { return different == 0 && lists == 0; }
    bool ok() const { return same_decisions() && largest() <= lockstep_ulps; }
};

/// Marches the scene once. A run that stops (Invn, a diverging deck) is compared until then.
/// @param first, second  who computes; the march goes on with the first
LockstepResult lockstep(const HostScene& scene, const MarchOptions& options, const MakeContact& first,
                        const MakeContact& second);
/// Reference first, optimized second.
LockstepResult lockstep(const HostScene& scene, const MarchOptions& options = {});

}  // namespace type21
