/// @file The file format of queries and answers: JSON, numbers as C99 hex floats.
///
///   {"family": "folds", "blocks": [{
///      "nodes": [["0x1p+0", "0x0p+0", "0x0p+0"], ...], "normals": [...], "segments": [[0, 1, 5, 4], ...],
///      "queries": [{"p": [...], "gap": "0x1p-2", "depth": "0x1p-2", "reach": "0x0p+0"}, ...],
///      "answers": [{"segment": 7, "triangle": 1, "side": -1, "kind": "contact"}, ...]}]}
///
/// Plain JSON numbers are read, too; what is written are hex floats, which lose no bit. "family" is the name of the
/// question family; it and "answers" may be absent. "reach" is ContactQuery::proximity_reach. The limits of a query are
/// not part of the format: they are the documented ones. Another key is a complaint; known, and passed over here, are
/// those of the atlas ("name", "title", "what", "warnings", "note", "double"), of the fuzzer ("with", "what", "found")
/// and of the output of decide ("with", "program", "stage_counts", in answers "stage", "margin", "margin_ulps", "ok").
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/decisions/queries/decision_block.h"
#include "verification/support/json_reader.h"

namespace type21 {

/// "0x1.8p+1": the same double on every machine.
std::string to_hex(double value);
nlohmann::ordered_json to_hex(const Vec3& value);

/// @param problems  every complaint, "FILE: /blocks/0/nodes/3/1: \"nan\" is not a finite number"; the result is
///                  only of use when none was added
DecisionFile read_decisions(const std::filesystem::path& file, std::vector<std::string>& problems);
DecisionFile decisions_of(const nlohmann::json& json, const std::string& name, std::vector<std::string>& problems);
/// The answers under a key of a block: one for each of its queries.
/// @param read  what was read of that block so far
std::vector<DecisionAnswer> read_answers(JsonReader& reader, const nlohmann::json& block, const char* key,
                                         const std::string& place, const DecisionBlock& read);

nlohmann::ordered_json to_json(const DecisionFile& file);
nlohmann::ordered_json to_json(const DecisionAnswer& answer);

}  // namespace type21
