/// @file What a long run has shown: numbers beside the order that theory expects of them.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace type21::stability {

/// One number. Nothing is asked of it where both bounds are infinite: it is shown only.
struct Finding {
    std::string what;
    double value = 0;
    std::string unit;  ///< "-" for a ratio
    double at_least = -std::numeric_limits<double>::infinity();
    double at_most = std::numeric_limits<double>::infinity();
    std::string expected;  ///< the order and where it comes from

    /// False for NaN, too.
    bool holds() const { return value >= at_least && value <= at_most; }
    bool asked() const {
        return at_least > -std::numeric_limits<double>::infinity() || at_most < std::numeric_limits<double>::infinity();
    }
};

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
