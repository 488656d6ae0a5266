/// @file What the bench must show, and whether it did.
#pragma once

#include <string>
#include <vector>

namespace type21::bench {

enum class Better { higher, lower };

struct Target {
    std::string target;  ///< "coherent step against Embree's full search, 20k"
    std::string scene;
    std::string unit;  ///< "x", "ns", "s", "B"
    Better better = Better::higher;
    double at_least = 0, aim = 0, measured = 0;
    std::string note;

    /// "aim", "at least" or "no"; the limits themselves count as reached, NaN does not.
    std::string reached() const;
};

/// One line for each, under a head.
std::string to_text(const std::vector<Target>& targets);

}  // namespace type21::bench
