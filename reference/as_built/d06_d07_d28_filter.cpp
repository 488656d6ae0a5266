#include "reference/as_built/d06_d07_d28_filter.h"

#include <algorithm>
#include <numbers>

namespace type21::reference::as_built {

namespace {

/// alpha before the step enters; for Ifiltr 3 per unit of time.
double without_step(int ifiltr, double xfreq, bool d07) {
    constexpr double turn = 2.0 * std::numbers::pi;
    if (ifiltr == 0 || xfreq == 0) return 1.0;
    if (ifiltr == 1) return xfreq;
    return ifiltr == 2 && d07 ? turn / xfreq : turn * xfreq;
}

}  // namespace

double filter_constant(const FilterDepartures& on, const Interface& interface, double step) {
    const bool of_card = on.d28 && interface.friction_model >= 0;
    const double factor = of_card ? without_step(interface.card_ifiltr, interface.card_xfreq, on.d07)
                                  : without_step(interface.ifiltr, interface.xfreq, on.d07);
    if (interface.ifiltr != 3) return std::min(1.0, factor);
    return on.d06 ? std::max(1.0, factor * step) : std::min(1.0, factor * step);
}

}  // namespace type21::reference::as_built
