/// @file Questions of the families by the million, each answer compared with an exact one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verification/decisions/queries/decide.h"
#include "verification/decisions/question_families/family.h"

namespace type21 {

struct FuzzOptions {
    long count = 10000;      ///< decisions for each family
    std::uint64_t seed = 1;  ///< other seeds, other questions
    DecideWith method = DecideWith::reference;
    int jobs = 1;          ///< threads; what comes out does not depend on it
    long full_every = 64;  ///< each such decision is looked at with Scrutiny::full
    size_t keep = 10;      ///< failures to keep of each family, the first ones
};

/// A question whose answer is wrong, and where it came from.
struct FuzzFailure {
    std::uint64_t block = 0;
    int query = 0;
    DecisionTool tool;
    DecisionQuery question;
    std::string what;
};

/// What a family came to.
struct FuzzTally {
    std::string family;
    long decisions = 0;
    long contact = 0, proximity = 0;
    long near_border = 0, margins = 0;  ///< of those looked at in full: margin below 1e6 ulps of the coordinates
    std::array<long, 3> settled{};      ///< by stage, where the method has stages
    long double_wrong = 0;              ///< that plain double arithmetic gets wrong
    long second_by_exact = 0;           ///< that intervals could not tell the second opinion
    long different = 0;                 ///< failures
    std::vector<FuzzFailure> failures;  ///< the first of them
    double seconds = 0;                 ///< wall time [s]
};

/// @param progress  called often with the share done, 0 to 1; never twice at the same time
FuzzTally fuzz(const Family& family, const FuzzOptions& options, const std::function<void(double)>& progress);

}  // namespace type21
