/// @file The atlas of hard cases: small tools and nodes with exact answers that another program computed.
///
/// An entry is a file in the format of decide (decision_json.h), with one block and beside it
///   "title": what it is, "what": one sentence about what makes it hard,
/// in the block "note": a few words for each query, "answers": the exact ones and "double": what plain double
/// arithmetic answers, both by scripts/exact_decisions.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/decisions/queries/decide.h"

namespace type21 {

struct AtlasEntry {
    std::string name;  ///< of the file
    std::string title, what;
    DecisionBlock block;
    std::vector<std::string> note;               ///< one for each query
    std::vector<DecisionAnswer> double_answers;  ///< one for each query, or none
    std::vector<std::string> warnings;           ///< of its tool
};

/// The files *.json of a folder by name, or those named.
/// @param problems  every complaint; the result is only of use when none was added
std::vector<AtlasEntry> read_atlas(const std::filesystem::path& folder, const std::vector<std::string>& names,
                                   std::vector<std::string>& problems);

/// One query of an entry, answered.
struct AtlasAnswer {
    DecisionAnswer program;  ///< with stage and margin
    DecisionAnswer plain;    ///< by double arithmetic
    bool ok = false;         ///< the program gives the answer of the file
};

std::vector<AtlasAnswer> answers_of(const AtlasEntry& entry, DecideWith method);

std::string to_text(const AtlasEntry& entry, const std::vector<AtlasAnswer>& answers);
/// All that a drawing needs: the tool, the nodes, and every answer.
nlohmann::ordered_json to_json(const AtlasEntry& entry, const std::vector<AtlasAnswer>& answers);

}  // namespace type21
