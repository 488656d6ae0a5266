/// @file Queries of the question families by the million; each answer is compared with an exact one.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "verification/decisions/queries/decide.h"
#include "verification/decisions/question_families/question_family.h"

namespace type21 {

struct FuzzOptions {
    long count = 10000;      ///< decisions for each question family
    std::uint64_t seed = 1;  ///< another seed gives other queries
    DecideWith method = DecideWith::reference;
    int jobs = 1;          ///< threads; the result does not depend on it
    long full_every = 64;  ///< every so many decisions, one is checked with Scrutiny::full
    size_t keep = 10;      ///< failures to keep of each question family: the first ones
};

/// A query whose answer is wrong, and where it came from.
struct FuzzFailure {
    std::uint64_t block = 0;  ///< index of the block in its question family
    int number = 0;           ///< of the query in its block
    DecisionTool tool;
    ContactQuery query;
    std::string what;  ///< what is wrong, in words
};

/// The counts of one question family.
struct FuzzTally {
    std::string family;  ///< its name; "all" for a sum
    long decisions = 0;
    long contact = 0, proximity = 0;
    long near_border = 0, margins = 0;  ///< of `margins` decisions checked in full: margin below near_border_ulps
    std::array<long, 3> settled{};      ///< by stage, where the method has stages
    long double_wrong = 0;              ///< decisions that plain double arithmetic gets wrong
    long second_by_exact = 0;           ///< decisions where the second opinion needed exact numbers
    long different = 0;                 ///< failures
    std::vector<FuzzFailure> failures;  ///< the first of them
    double seconds = 0;                 ///< wall time [s]
};

/// Adds the counts of `part` to `sum`; family, failures and seconds of `sum` stay.
void add_counts(FuzzTally& sum, const FuzzTally& part);

/// @param progress  called often with the share done, 0 to 1; never twice at the same time
FuzzTally fuzz(const QuestionFamily& family, const FuzzOptions& options, const std::function<void(double)>& progress);

}  // namespace type21
