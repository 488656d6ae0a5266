#include "verification/decisions/queries/decision_json.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "verification/support/json_file.h"
#include "verification/support/shown_text.h"

namespace type21 {

using Json = nlohmann::json;

std::string_view name(Kind kind) {
    switch (kind) {
        case Kind::contact:
            return "contact";
        case Kind::proximity:
            return "proximity";
        case Kind::none:
            break;
    }
    return "none";
}

std::string_view name(Stage stage) {
    switch (stage) {
        case Stage::bounded:
            return "double";
        case Stage::interval:
            return "interval";
        case Stage::exact:
            break;
    }
    return "exact";
}

std::string to_hex(double value) {
    return fmt::format("{:a}", value);
}

nlohmann::ordered_json to_hex(const Vec3& value) {
    return {to_hex(value.x()), to_hex(value.y()), to_hex(value.z())};
}

namespace {

/// The keys of the format, those that only the atlas, the fuzzer or the output of decide has among them.
const JsonReader::Keys file_keys{"family",   "blocks", "name",  "title",   "what",
                                 "warnings", "with",   "found", "program", "stage_counts"};
const JsonReader::Keys block_keys{"nodes", "normals", "segments", "queries", "answers", "note", "double", "program"};
const JsonReader::Keys query_keys{"p", "gap", "depth", "reach"};
const JsonReader::Keys answer_keys{"segment", "triangle", "side", "kind", "stage", "margin", "margin_ulps", "ok"};

/// Calls read(value, place) for each value of the list under a key.
template <class Read>
void each(JsonReader& reader, const Json& object, const char* key, const std::string& place, Read&& read) {
    const Json& list = reader.list(object, key, place);
    for (size_t i = 0; i < list.size(); ++i)
        read(list[i], json_place(json_place(place, key), i));
}

double length_at_least_0(JsonReader& reader, const Json& object, const char* key, const std::string& place) {
    const Json* json = reader.member(object, key, place, "a length");
    if (!json) return 0;
    const double value = reader.number(*json, json_place(place, key));
    if (value < 0)
        reader.complain(json_place(place, key), fmt::format("{} [length] is negative; it must be 0 or more", value));
    return value;
}

Vec3 read_vector(JsonReader& reader, const Json& json, const std::string& place) {
    if (!json.is_array() || json.size() != 3) {
        reader.complain(place, fmt::format("{} stands where a list of three numbers is wanted", shown_json(json)));
        return Vec3::Zero();
    }
    Vec3 value;
    for (size_t i = 0; i < 3; ++i)
        value[static_cast<Eigen::Index>(i)] = reader.number(json[i], json_place(place, i));
    return value;
}

std::array<int, 4> read_segment(JsonReader& reader, const Json& json, size_t nodes, const std::string& place) {
    std::array<int, 4> corner{};
    if (!json.is_array() || json.size() != 4) {
        reader.complain(place, fmt::format("{} stands where a list of four node indices is wanted; a triangle repeats "
                                           "its third",
                                           shown_json(json)));
        return corner;
    }
    for (size_t j = 0; j < 4; ++j)
        corner[j] = static_cast<int>(
            reader.integer(json[j], json_place(place, j), 0, static_cast<long>(nodes) - 1, "the index of a node:"));
    return corner;
}

ContactQuery read_query(JsonReader& reader, const Json& json, const std::string& place) {
    ContactQuery query;
    if (!reader.object(json, place, query_keys)) return query;
    if (const Json* point = reader.member(json, "p", place, "the position of the node"))
        query.point = read_vector(reader, *point, json_place(place, "p"));
    query.gap = length_at_least_0(reader, json, "gap", place);
    query.depth = length_at_least_0(reader, json, "depth", place);
    if (json.contains("reach")) query.proximity_reach = length_at_least_0(reader, json, "reach", place);
    return query;
}

DecisionAnswer read_answer(JsonReader& reader, const Json& json, size_t segments, const std::string& place) {
    DecisionAnswer answer;
    if (!reader.object(json, place, answer_keys)) return answer;
    const auto whole = [&](const char* key, std::string_view what, long low, long high) {
        const Json* value = reader.member(json, key, place, what);
        return value ? static_cast<int>(reader.integer(*value, json_place(place, key), low, high)) : 0;
    };
    const Json* word = reader.member(json, "kind", place, "contact, proximity or none");
    if (!word) return answer;
    const std::string kind = reader.text(*word, json_place(place, "kind"));
    answer.kind = kind == "contact" ? Kind::contact : (kind == "proximity" ? Kind::proximity : Kind::none);
    if (word->is_string() && name(answer.kind) != kind)
        reader.complain(json_place(place, "kind"),
                        fmt::format("'{}' is not contact, proximity or none", shown(std::string_view(kind))));
    const bool none = answer.kind == Kind::none;
    answer.segment =
        whole("segment", "the rank of a segment, -1 for none", -1, none ? -1 : static_cast<long>(segments) - 1);
    if (none) return answer;
    answer.triangle = whole("triangle", "a sub-triangle, 1 to 4", 1, 4);
    answer.side = whole("side", "+1 or -1", -1, 1);
    return answer;
}

DecisionBlock read_block(JsonReader& reader, const Json& json, const std::string& place) {
    DecisionBlock block;
    if (!reader.object(json, place, block_keys)) return block;
    DecisionTool& tool = block.tool;
    each(reader, json, "nodes", place,
         [&](const Json& j, const std::string& at) { tool.node.push_back(read_vector(reader, j, at)); });
    each(reader, json, "normals", place,
         [&](const Json& j, const std::string& at) { tool.normal.push_back(read_vector(reader, j, at)); });
    if (tool.normal.size() != tool.node.size())
        reader.complain(json_place(place, "normals"), fmt::format("{} normals for {} nodes; each node needs one",
                                                                  tool.normal.size(), tool.node.size()));
    each(reader, json, "segments", place, [&](const Json& j, const std::string& at) {
        tool.segment.push_back(read_segment(reader, j, tool.node.size(), at));
    });
    each(reader, json, "queries", place,
         [&](const Json& j, const std::string& at) { block.queries.push_back(read_query(reader, j, at)); });
    if (json.contains("note"))
        each(reader, json, "note", place, [&](const Json& j, const std::string& at) { reader.text(j, at); });
    if (json.contains("answers")) block.answers = read_answers(reader, json, "answers", place, block);
    return block;
}

}  // namespace

std::vector<DecisionAnswer> read_answers(JsonReader& reader, const Json& block, const char* key,
                                         const std::string& place, const DecisionBlock& read) {
    std::vector<DecisionAnswer> answers;
    each(reader, block, key, place, [&](const Json& j, const std::string& at) {
        answers.push_back(read_answer(reader, j, read.tool.segment.size(), at));
    });
    if (answers.size() != read.queries.size())
        reader.complain(json_place(place, key),
                        fmt::format("{} answers for {} queries", answers.size(), read.queries.size()));
    return answers;
}

DecisionFile decisions_of(const Json& json, const std::string& name, std::vector<std::string>& problems) {
    JsonReader reader(name, problems);
    DecisionFile file;
    if (!reader.object(json, "", file_keys)) return file;
    const auto text = [&](const char* key) {
        return json.contains(key) ? reader.text(json[key], json_place("", key)) : std::string();
    };
    for (const char* passed_over : {"name", "title", "what", "program"})
        text(passed_over);
    file.family = text("family");
    file.with = text("with");
    each(reader, json, "blocks", "",
         [&](const Json& j, const std::string& at) { file.blocks.push_back(read_block(reader, j, at)); });
    return file;
}

DecisionFile read_decisions(const std::filesystem::path& file, std::vector<std::string>& problems) {
    const std::optional<Json> json = read_json(file, problems);
    return json ? decisions_of(*json, shown(file.string(), 400), problems) : DecisionFile();
}

nlohmann::ordered_json to_json(const DecisionAnswer& answer) {
    nlohmann::ordered_json json;
    json["segment"] = answer.segment;
    if (answer.kind != Kind::none) {
        json["triangle"] = answer.triangle;
        json["side"] = answer.side;
    }
    json["kind"] = name(answer.kind);
    json["stage"] = name(answer.stage);
    // JSON has no infinity: nothing in reach means no margin.
    if (std::isfinite(answer.margin)) {
        json["margin"] = to_hex(answer.margin);
        json["margin_ulps"] = answer.margin_ulps;
    } else {
        json["margin"] = nullptr;
        json["margin_ulps"] = nullptr;
    }
    return json;
}

nlohmann::ordered_json to_json(const DecisionFile& file) {
    nlohmann::ordered_json json;
    if (!file.family.empty()) json["family"] = file.family;
    json["blocks"] = nlohmann::ordered_json::array();
    for (const DecisionBlock& block : file.blocks) {
        nlohmann::ordered_json one;
        for (const char* key : {"nodes", "normals", "segments", "queries"})
            one[key] = nlohmann::ordered_json::array();
        for (const Vec3& node : block.tool.node)
            one["nodes"].push_back(to_hex(node));
        for (const Vec3& normal : block.tool.normal)
            one["normals"].push_back(to_hex(normal));
        for (const auto& segment : block.tool.segment)
            one["segments"].push_back(segment);
        for (const ContactQuery& query : block.queries)
            one["queries"].push_back({{"p", to_hex(query.point)},
                                      {"gap", to_hex(query.gap)},
                                      {"depth", to_hex(query.depth)},
                                      {"reach", to_hex(query.proximity_reach)}});
        for (const DecisionAnswer& answer : block.answers)
            one["answers"].push_back(to_json(answer));
        json["blocks"].push_back(std::move(one));
    }
    return json;
}

}  // namespace type21
