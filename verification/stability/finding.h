/// @file The result of a long run: numbers beside the order of magnitude that theory gives them.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace type21::stability {

/// One number with the bounds that it must keep. Where both bounds are infinite it is only shown.
struct Finding {
    std::string what;
    double value = 0;
    std::string unit;  ///< "-" for a ratio
    double at_least = -std::numeric_limits<double>::infinity();
    double at_most = std::numeric_limits<double>::infinity();
    std::string expected;  ///< the order of magnitude and where it comes from

    /// False for NaN, too.
    bool holds() const { return value >= at_least && value <= at_most; }
    /// True when the number has a bound to keep.
    bool has_bound() const {
        return at_least > -std::numeric_limits<double>::infinity() || at_most < std::numeric_limits<double>::infinity();
    }
};

/// One long run. It holds when it has findings and all of them hold.
struct LongRun {
    std::string name;
    std::string statement;
    long cycles = 0;
    std::vector<Finding> findings;

    bool holds() const {
        for (const Finding& finding : findings) {
            if (!finding.holds()) return false;
        }
        return !findings.empty();
    }
};

}  // namespace type21::stability
