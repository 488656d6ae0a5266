#include "reference/contact/friction_filter.h"

#include <algorithm>
#include <numbers>

namespace type21::reference {

double filter_constant(const Interface& interface, double step) {
    constexpr double turn = 2.0 * std::numbers::pi;
    const double xfreq = interface.xfreq;
    switch (xfreq == 0 ? 0 : interface.ifiltr.value) {
        case 1:
            return std::min(1.0, xfreq);
        case 2:
            return std::min(1.0, turn * xfreq);
        case 3:
            return std::min(1.0, turn * xfreq * step);
        default:
            return 1.0;
    }
}

}  // namespace type21::reference
