/// @file Conditions on C1..C6 and Xfreq.
#include "reference/model/friction_conditions.h"

#include <fmt/format.h>

namespace type21 {

/// @manual comment 13
std::vector<ConditionFault> renard_faults(const std::array<double, 6>& c, const UnitSystem& units) {
    std::vector<ConditionFault> faults;
    const auto ask = [&](bool holds, size_t rank, std::string rule, std::string remedy) {
        if (!holds) faults.push_back({rank, std::move(rule), std::move(remedy)});
    };
    ask(c[4] > 0, 4, "Renard law: the first critical speed C5 must be above 0", "Give C5 > 0");
    ask(c[4] < c[5], 4,
        fmt::format("Renard law: the first critical speed C5 must be below the second, C6 = {} {}", c[5],
                    units.name(dim::velocity)),
        "Give C5 < C6");
    ask(c[0] < c[2], 0, fmt::format("Renard law: the static coefficient C1 must be below the largest, C3 = {}", c[2]),
        "Give C1 < C3");
    ask(c[1] < c[2], 1, fmt::format("Renard law: the dynamic coefficient C2 must be below the largest, C3 = {}", c[2]),
        "Give C2 < C3");
    ask(c[3] < c[0], 3,
        fmt::format("Renard law: the smallest coefficient C4 must be below the static one, C1 = {}", c[0]),
        "Give C4 < C1");
    ask(c[3] < c[1], 3,
        fmt::format("Renard law: the smallest coefficient C4 must be below the dynamic one, C2 = {}", c[1]),
        "Give C4 < C2");
    return faults;
}

/// @manual field Xfreq; comment 15
std::optional<ConditionFault> filter_fault(int ifiltr, double xfreq) {
    if (xfreq < 0) return ConditionFault{0, "must not be negative", "Give 0 for no filter, or a positive value"};
    if (xfreq == 0) return std::nullopt;
    if ((ifiltr == 1 || ifiltr == 2) && xfreq > 1)
        return ConditionFault{
            0, fmt::format("must be between 0 and 1 with Ifiltr {}", ifiltr),
            ifiltr == 1 ? "Give the filter factor itself" : "Give the time step over the filtering period"};
    return std::nullopt;
}

}  // namespace type21
