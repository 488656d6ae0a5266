/// @file Steps the reference and the optimized contact side by side. In every cycle both get the same state, and their
/// outputs are compared. The run continues with the output of the reference.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/host/march.h"
#include "verification/criteria/lockstep/ulp_tally.h"

namespace type21 {

/// Largest difference allowed: 4 units in the last place of the magnitudes that enter a number (node_scale.h). Both
/// evaluate the same equations, with a few roundings in another order.
inline constexpr double lockstep_ulps = 4.0;

/// The first difference.
struct LockstepDifference {
    LockstepPlace place;
    std::string what;  ///< "decision: contact, segment 4, triangle 1, side +1; the reference: none"
};

struct LockstepResult {
    long cycles = 0;     ///< in which an interface was active
    long decisions = 0;  ///< nodes times cycles
    long in_contact = 0;
    long different = 0;  ///< decisions
    long grazing = 0;    ///< nodes with a penetration within rounding in one of the two, and none in the other
    long lists = 0;      ///< released nodes and inverted normals that differ
    std::vector<UlpTally> tally;
    std::optional<LockstepDifference> first_decision, first_force;

    LockstepResult();
    LockstepResult& operator+=(const LockstepResult& other);
    /// The largest of all quantities [ulps].
    double largest() const;
    bool same_decisions() const { return different == 0 && lists == 0; }
    bool ok() const { return same_decisions() && largest() <= lockstep_ulps; }
};

/// Marches the scene once. A run that stops (Invn, a diverging deck) is compared until then.
/// @param first, second  the two implementations; the run continues with the first
LockstepResult lockstep(const HostScene& scene, const MarchOptions& options, const MakeContact& first,
                        const MakeContact& second);
/// Reference first, optimized second.
LockstepResult lockstep(const HostScene& scene, const MarchOptions& options = {});

}  // namespace type21
