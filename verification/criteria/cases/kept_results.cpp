#include "verification/criteria/cases/kept_results.h"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "verification/criteria/cases/digest.h"

namespace type21 {
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

/// The fields of a column that are kept. A criterion that holds has no first difference above its tolerance.
template <class Column, class Visit>
void each_field_of_column(Column& one, const Visit& visit) {
    visit("column", one.column);
    visit("difference", one.difference);
    visit("scale", one.scale);
    visit("scaled", one.scaled);
    visit("time", one.time);
    visit("object", one.object);
    visit("ours", one.ours);
    visit("reference", one.reference);
    visit("tolerance", one.tolerance);
    visit("ok", one.ok);
    visit("remark", one.remark);
}

/// The fields of a result that are kept, but for its columns.
template <class Result, class Visit>
void each_field(Result& one, const Visit& visit) {
    visit("id", one.id);
    visit("case", one.case_name);
    visit("run", one.run);
    visit("kind", one.kind);
    visit("equation", one.equation);
    visit("expected", one.expected);
    visit("got", one.got);
    visit("expected_number", one.expected_number);
    visit("got_number", one.got_number);
    visit("difference", one.difference);
    visit("tolerance", one.tolerance);
    visit("unit", one.unit);
    visit("reason", one.reason);
    visit("ok", one.ok);
    visit("skipped", one.skipped);
    visit("seconds", one.seconds);
    visit("detail", one.detail);
}

/// Into JSON; a field without a value is left out.
struct Write {
    Json& json;
    template <class T>
    void operator()(const char* name, const T& value) const {
        json[name] = value;
    }
    template <class T>
    void operator()(const char* name, const std::optional<T>& value) const {
        if (value) json[name] = *value;
    }
};

/// Out of JSON; throws where a field is missing or of another kind.
struct Read {
    const Json& json;
    template <class T>
    void operator()(const char* name, T& value) const {
        json.at(name).get_to(value);
    }
    template <class T>
    void operator()(const char* name, std::optional<T>& value) const {
        if (json.contains(name)) value = json.at(name).get<T>();
    }
};

Json to_json(const CriterionResult& one) {
    Json json;
    each_field(one, Write{json});
    json["columns"] = Json::array();
    for (const ColumnResult& column : one.columns)
        each_field_of_column(column, Write{json["columns"].emplace_back(Json::object())});
    return json;
}

CriterionResult result_of(const Json& json) {
    CriterionResult one;
    each_field(one, Read{json});
    one.kept = true;
    for (const Json& column : json.at("columns"))
        each_field_of_column(one.columns.emplace_back(), Read{column});
    return one;
}

fs::path file_of(const fs::path& folder) {
    return folder.string() + ".criteria.json";
}

/// A deck that is refused leaves no folder: what its criteria give depends on the key only.
std::string digest_of_results(const fs::path& folder) {
    return fs::exists(folder) ? digest_of(folder) : "none";
}

}  // namespace

std::optional<std::vector<CriterionResult>> kept_results(const fs::path& folder, const std::string& key) {
    try {
        std::ifstream in(file_of(folder));
        if (!in) return std::nullopt;
        const Json kept = Json::parse(in);
        if (kept.at("key") != key || kept.at("results") != digest_of_results(folder)) return std::nullopt;
        std::vector<CriterionResult> results;
        for (const Json& one : kept.at("criteria"))
            results.push_back(result_of(one));
        return results;
    } catch (const std::exception&) {
        return std::nullopt;  // a damaged file counts as none: the run is done again
    }
}

void keep_results(const fs::path& folder, const std::string& key, const std::vector<CriterionResult>& results) {
    std::error_code error;
    fs::remove(file_of(folder), error);
    if (!std::all_of(results.begin(), results.end(), [](const CriterionResult& one) { return one.ok; })) return;
    Json kept = {{"key", key}, {"results", digest_of_results(folder)}, {"criteria", Json::array()}};
    for (const CriterionResult& one : results)
        kept["criteria"].push_back(to_json(one));
    // If the file cannot be written, or holds a number that JSON does not have, the run is done again the next time.
    std::ofstream out(file_of(folder), std::ios::binary | std::ios::trunc);
    out << kept.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace type21
