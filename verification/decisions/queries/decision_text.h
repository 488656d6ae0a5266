/// @file What a set of answers amounts to.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/decisions/queries/decide.h"

namespace type21 {

/// A node whose margin is smaller is near a border: about 1e-10 of its coordinates.
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
/// "double 96.1 %, interval 0.2 %, exact 3.7 %; double alone would have got 12 wrong; ..."; nothing for no decisions.
std::string to_text(const DecisionStageCounts& stage_counts);
nlohmann::ordered_json to_json(const DecisionStageCounts& stage_counts);

}  // namespace type21
