/// @file Many queries answered: counts, comparison with the answers of the file, and both as text.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/decisions/queries/decide.h"

namespace type21 {

/// A node whose margin is smaller than this is near another answer: about 1e-10 of its coordinates [ulp].
inline constexpr double near_border_ulps = 1e6;

struct DecisionTally {
    long queries = 0;
    long contact = 0, proximity = 0;
    long near_border = 0;                ///< margin below near_border_ulps
    long compared = 0;                   ///< answers that the file brought along
    std::vector<std::string> different;  ///< "block 0, query 3: segment 7 ..., the file says ..."
    DecisionStageCounts stage_counts;
};

/// Answers every query; what answers the file had are compared and replaced.
DecisionTally answer_all(DecisionFile& file, DecideWith method);

/// "contact with segment 3, triangle 2, side +1", "none".
std::string in_words(const DecisionAnswer& answer);

std::string to_text(const DecisionTally& tally);
/// "decisions 324: 96.1 % settled by double, 0.2 % by interval, 3.7 % exactly; plain double would have been wrong in
/// 12; ..."; an empty text where nothing was decided.
std::string to_text(const DecisionStageCounts& counts);
nlohmann::ordered_json to_json(const DecisionStageCounts& counts);

}  // namespace type21
