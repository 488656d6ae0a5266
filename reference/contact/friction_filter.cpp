#include "reference/contact/friction_filter.h"

#include <algorithm>
#include <numbers>

namespace type21::reference {

namespace {

/// alpha before the step enters; for Ifiltr 3 per unit of time.
double raw_constant(int ifiltr, double xfreq, const AsBuilt& as_built) {
    constexpr double turn = 2.0 * std::numbers::pi;
    if (ifiltr == 0 || xfreq == 0) return 1.0;
    if (ifiltr == 1) return xfreq;
    if (ifiltr == 2) return as_built.has(Departure::D07) ? turn / xfreq : turn * xfreq;
    return turn * xfreq;
}

}  // namespace

double filter_constant(const Interface& interface, double step, const AsBuilt& as_built) {
    const bool card = interface.friction_model >= 0 && as_built.has(Departure::D28);
    const double raw = card ? raw_constant(interface.card_ifiltr, interface.card_xfreq, as_built)
                            : raw_constant(interface.ifiltr, interface.xfreq, as_built);
    if (interface.ifiltr == 3) {
        return as_built.has(Departure::D06) ? std::max(1.0, raw * step) : std::min(1.0, raw * step);
    }
    return std::min(1.0, raw);
}

}  // namespace type21::reference
