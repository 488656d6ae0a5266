#include "verification/decisions/queries/decision_json.h"

#include <cmath>
#include <cstdlib>
#include <fstream>

#include <fmt/format.h>

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

/// Reads one document. Every complaint comes with its place, a JSON pointer.
class Reader {
  public:
    Reader(std::string name, std::vector<std::string>& problems) : name_(std::move(name)), problems_(problems) {}

    void complain(const std::string& place, const std::string& what) {
        problems_.push_back(fmt::format("{}: {}: {}", name_, place.empty() ? "/" : place, what));
    }

    double number(const Json& json, const std::string& place) {
        if (json.is_number()) return json.get<double>();
        if (json.is_string()) {
            const std::string& text = json.get_ref<const std::string&>();
            char* end = nullptr;
            const double value = std::strtod(text.c_str(), &end);
            if (!text.empty() && end == text.c_str() + text.size() && std::isfinite(value)) return value;
        }
        complain(place, fmt::format("{} is not a finite number; write a hex float such as \"0x1.8p+1\"", json.dump()));
        return 0;
    }

    double limit(const Json& object, const char* key, const std::string& place) {
        if (!object.contains(key)) {
            complain(place, fmt::format("'{}' is missing; it is a length", key));
            return 0;
        }
        const std::string here = fmt::format("{}/{}", place, key);
        const double value = number(object.at(key), here);
        if (value < 0) complain(here, fmt::format("{} [length] is negative; it must be 0 or more", value));
        return value;
    }

    Vec3 vector(const Json& json, const std::string& place) {
        if (!json.is_array() || json.size() != 3) {
            complain(place, "this must be a list of three numbers");
            return Vec3::Zero();
        }
        Vec3 value;
        for (int i = 0; i < 3; ++i)
            value[i] = number(json[static_cast<size_t>(i)], fmt::format("{}/{}", place, i));
        return value;
    }

    /// @return the array under a key, or nothing with a complaint
    const Json& array(const Json& object, const char* key, const std::string& place) {
        static const Json none = Json::array();
        if (object.is_object() && object.contains(key) && object.at(key).is_array()) return object.at(key);
        complain(place, fmt::format("'{}' is missing or not a list", key));
        return none;
    }

    std::array<int, 4> segment(const Json& json, size_t nodes, const std::string& place) {
        std::array<int, 4> corner{};
        if (!json.is_array() || json.size() != 4) {
            complain(place, "this must be a list of four node indices; a triangle repeats its third");
            return corner;
        }
        for (size_t j = 0; j < 4; ++j) {
            const bool known = json[j].is_number_integer() && json[j].get<long>() >= 0 &&
                               json[j].get<long>() < static_cast<long>(nodes);
            if (known)
                corner[j] = json[j].get<int>();
            else
                complain(fmt::format("{}/{}", place, j),
                         fmt::format("{} is not the index of a node: 0 to {}", json[j].dump(), nodes - 1));
        }
        return corner;
    }

    DecisionAnswer answer(const Json& json, const std::string& place) {
        DecisionAnswer value;
        if (!json.is_object() || !json.contains("segment") || !json["segment"].is_number_integer()) {
            complain(place, "an answer needs 'segment', 'triangle', 'side' and 'kind'");
            return value;
        }
        const std::string kind = json.value("kind", "");
        value.kind = kind == "contact" ? Kind::contact : (kind == "proximity" ? Kind::proximity : Kind::none);
        if (name(value.kind) != kind) complain(place, fmt::format("kind '{}' is not contact, proximity or none", kind));
        value.segment = json["segment"];
        if (value.kind != Kind::none) {
            value.triangle = json.value("triangle", 0);
            value.side = json.value("side", 0);
        }
        return value;
    }

    DecisionBlock block(const Json& json, const std::string& place) {
        DecisionBlock block;
        const auto each = [&](const char* key, auto&& read) {
            const Json& list = array(json, key, place);
            for (size_t i = 0; i < list.size(); ++i)
                read(list[i], fmt::format("{}/{}/{}", place, key, i));
        };
        each("nodes", [&](const Json& j, const std::string& at) { block.tool.node.push_back(vector(j, at)); });
        each("normals", [&](const Json& j, const std::string& at) { block.tool.normal.push_back(vector(j, at)); });
        if (block.tool.normal.size() != block.tool.node.size())
            complain(place + "/normals", fmt::format("{} normals for {} nodes; each node needs one",
                                                     block.tool.normal.size(), block.tool.node.size()));
        each("segments", [&](const Json& j, const std::string& at) {
            block.tool.segment.push_back(segment(j, block.tool.node.size(), at));
        });
        each("queries", [&](const Json& j, const std::string& at) {
            if (!j.is_object() || !j.contains("p")) return complain(at, "'p' is missing; it is the node's position");
            block.queries.push_back({vector(j["p"], at + "/p"), limit(j, "gap", at), limit(j, "depth", at),
                                     j.contains("reach") ? limit(j, "reach", at) : 0.0});
        });
        if (json.is_object() && json.contains("answers")) {
            each("answers", [&](const Json& j, const std::string& at) { block.answers.push_back(answer(j, at)); });
            if (block.answers.size() != block.queries.size())
                complain(place + "/answers",
                         fmt::format("{} answers for {} queries", block.answers.size(), block.queries.size()));
        }
        return block;
    }

  private:
    std::string name_;
    std::vector<std::string>& problems_;
};

}  // namespace

DecisionFile decisions_of(const Json& json, const std::string& name, std::vector<std::string>& problems) {
    Reader reader(name, problems);
    DecisionFile file;
    if (json.is_object()) file.family = json.value("family", "");
    const Json& blocks = reader.array(json, "blocks", "");
    for (size_t i = 0; i < blocks.size(); ++i)
        file.blocks.push_back(reader.block(blocks[i], fmt::format("/blocks/{}", i)));
    return file;
}

DecisionFile read_decisions(const std::filesystem::path& file, std::vector<std::string>& problems) {
    std::ifstream stream(file);
    if (!stream || std::filesystem::is_directory(file)) {
        problems.push_back(fmt::format("{}: cannot be read", file.string()));
        return {};
    }
    try {
        return decisions_of(Json::parse(stream), file.string(), problems);
    } catch (const Json::parse_error& error) {
        problems.push_back(fmt::format("{}: byte {}: is not JSON", file.string(), error.byte));
    } catch (const Json::type_error& error) {
        problems.push_back(fmt::format("{}: a value has the wrong type: {}", file.string(), error.what()));
    }
    return {};
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
