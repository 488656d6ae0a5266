/// @file The cost of an effect when it is on, and the proof that it costs nothing when it is off.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/contract/interface.h"
#include "verification/performance/accuracy/timing.h"

namespace type21::accuracy {

/// An effect, by the fields of the card. Three cards are compared: without the effect, off and on.
struct EffectCard {
    std::string name;
    std::string off_means;                    ///< "Fric 0, with Xfreq and C1 to C6 given"
    bool lean = true;                         ///< a lean step of the optimized implementation reports all of it
    void (*base)(Interface& card) = nullptr;  ///< fields that the effect needs, in all three cards
    void (*off)(Interface& card) = nullptr;   ///< all fields of the effect, except the one that switches it on
    void (*on)(Interface& card) = nullptr;    ///< the field that switches it on
};
const std::vector<EffectCard>& effect_cards();

/// Time of whole contact cycles, per node and cycle. Four contacts are stepped in turn with the same motion: without
/// the effect, once more without it, off, on.
struct EffectCost {
    std::string effect, off_means, implementation;
    bool lean = false;
    size_t nodes = 0, cycles = 0;
    TimingSpread absent, off, on;  ///< [ns]
    double extra = 0;              ///< median of on - off, cycle by cycle [ns]
    double off_ratio = 0;          ///< median of off / absent, cycle by cycle [-]
    double same_ratio = 0;         ///< median of absent again / absent: the accuracy of such a ratio [-]
    double off_error = 0;          ///< standard error of off_ratio, from the spread of the cycles [-]
    double extra_error = 0;        ///< of extra [ns]
    /// With the effect off, the scene plans the same effects as without it: nothing of it is there to cost anything.
    bool same_program = false;
    size_t bytes_absent = 0, bytes_off = 0, bytes_on = 0;  ///< held per node
    bool changes_forces = false;                           ///< on gives other forces or heat than off: the effect acts
};

/// @param fast   true: the optimized implementation; false: the reference
/// @param nodes  along each side of the sheet
EffectCost effect_cost(const EffectCard& card, bool fast, int nodes, int cycles);
/// All effects, with both implementations.
std::vector<EffectCost> effect_costs(bool quick, const std::function<void(const std::string&)>& progress);

}  // namespace type21::accuracy
