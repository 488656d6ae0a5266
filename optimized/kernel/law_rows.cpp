// Friction coefficients that depend on pressure, speed or the pair of parts, for the columns of a register.
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

/// @manual eq 9; field Ifric
void coefficients_in_rows(const ForceCycle& c, const Search::Batch& at, ForceRows& f, int column, int count) {
    const Laws& laws = *c.laws;
    for (int j = column; j < column + count; ++j) {
        f.mu[j] = 0;
        if (f.in_contact[j] == 0) continue;
        f.mu[j] = laws.friction_coefficient(f.rank + j, at.id[f.at + j].segment(), f.normal_force[j], f.sliding[j], 1.0,
                                            *f.lists);
    }
}

}  // namespace type21::optimized
