/// @file What an effect costs when it is on, and that it costs nothing when it is off.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/contract/interface.h"
#include "verification/performance/accuracy/timing.h"

namespace type21::accuracy {

/// An effect by what its card says. The other two cards begin as the card without it.
struct EffectCard {
    std::string name;
    std::string off_means;                    ///< "Fric 0, with Xfreq and C1 to C6 given"
    bool lean = true;                         ///< what it reports fits into a lean step of the optimized implementation
    void (*base)(Interface& card) = nullptr;  ///< what the effect builds on, in all three
    void (*off)(Interface& card) = nullptr;   ///< all its fields but for the one that asks for it
    void (*on)(Interface& card) = nullptr;    ///< the same, and that one
};
const std::vector<EffectCard>& effect_cards();

/// Whole cycles of the contact, per node and cycle. Four contacts are stepped in turn with the same motion: without the
/// effect, the same again, switched off, on.
struct EffectCost {
    std::string effect, off_means, implementation;
    bool lean = false;
    size_t nodes = 0, cycles = 0;
    Spread absent, off, on;  ///< [ns]
    double extra = 0;        ///< median of on - off, cycle by cycle [ns]
    double off_ratio = 0;    ///< median of off / absent, cycle by cycle [-]
    double same_ratio = 0;   ///< median of absent again / absent: what such a ratio is worth [-]
    double off_error = 0;    ///< standard error of off_ratio, from the spread of the cycles [-]
    double extra_error = 0;  ///< of extra [ns]
    /// The scene plans the same effects with the card switched off as with the card that does not name the effect:
    /// nothing of it is there to cost anything.
    bool same_program = false;
    size_t bytes_absent = 0, bytes_off = 0, bytes_on = 0;  ///< held per node
    bool changes_forces = false;                           ///< on gives other forces or heat than off: it was at work
};

/// @param fast   the optimized implementation, else the reference
/// @param nodes  along each side of the sheet
EffectCost effect_cost(const EffectCard& card, bool fast, int nodes, int cycles);
/// All of them, of both implementations.
std::vector<EffectCost> effect_costs(bool quick, const std::function<void(const std::string&)>& progress);

}  // namespace type21::accuracy
