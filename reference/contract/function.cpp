#include "function.h"

#include <algorithm>
#include <cstddef>

namespace type21 {

/// y1 + (x - x1) (y2 - y1) / (x2 - x1) on the interval of x, that of the nearest end outside.
double Function::operator()(double abscissa) const {
    if (x.empty()) return 0;
    if (x.size() == 1) return y.front();
    const auto above = std::upper_bound(x.begin() + 1, x.end() - 1, abscissa);
    const auto i = static_cast<std::size_t>(above - x.begin());
    const double slope = (y[i] - y[i - 1]) / (x[i] - x[i - 1]);
    return y[i - 1] + slope * (abscissa - x[i - 1]);
}

}  // namespace type21
