// Friction coefficients that hang on pressure, speed or the pair of parts, for the columns of a register.
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

void coefficients_in_rows(const ForceCycle& c, const Search::Batch& at, int first, ForceRows& f, int column,
                          int count) {
    const Laws& laws = *c.laws;
    for (int j = column; j < column + count; ++j) {
        f.mu[j] = 0;
        if (f.closed[j] == 0) continue;
        const int rank = f.rank + j;
        const double area = laws.card->secondary.area[static_cast<size_t>(rank)];
        const double pressure = area > 0 ? f.normal_force[j] / area : 0.0;
        f.mu[j] = laws.friction_law.coefficient(laws.friction_table.at(rank, segment_of(at.place[first + j])), pressure,
                                                f.sliding[j], 1.0);
    }
}

}  // namespace type21::optimized
