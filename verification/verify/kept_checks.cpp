#include "verification/verify/kept_checks.h"

#include <algorithm>
#include <fstream>

#include <nlohmann/json.hpp>

#include "verification/verify/digest.h"

namespace type21 {
namespace fs = std::filesystem;
using Json = nlohmann::json;

namespace {

template <class T>
Json or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json();
}

template <class T>
std::optional<T> optional_of(const Json& json) {
    if (json.is_null()) return std::nullopt;
    return json.get<T>();
}

Json to_json(const ColumnResult& one) {
    return {{"column", one.column},       {"difference", one.difference},
            {"scale", one.scale},         {"scaled", one.scaled},
            {"time", one.time},           {"object", or_null(one.object)},
            {"ours", one.ours},           {"reference", one.reference},
            {"tolerance", one.tolerance}, {"ok", one.ok},
            {"remark", one.remark}};
}

ColumnResult column_of(const Json& json) {
    ColumnResult one;
    one.column = json.at("column");
    one.difference = json.at("difference");
    one.scale = json.at("scale");
    one.scaled = json.at("scaled");
    one.time = json.at("time");
    one.object = optional_of<Id>(json.at("object"));
    one.ours = json.at("ours");
    one.reference = json.at("reference");
    one.tolerance = json.at("tolerance");
    one.ok = json.at("ok");
    one.remark = json.at("remark");
    return one;  // nothing is above the tolerance of a check that holds: there is no first such difference
}

Json to_json(const CheckResult& one) {
    Json json = {{"id", one.id},
                 {"case", one.case_name},
                 {"run", one.run},
                 {"kind", one.kind},
                 {"equation", one.equation},
                 {"expected", one.expected},
                 {"got", one.got},
                 {"expected_number", or_null(one.expected_number)},
                 {"got_number", or_null(one.got_number)},
                 {"difference", one.difference},
                 {"tolerance", one.tolerance},
                 {"unit", one.unit},
                 {"reason", one.reason},
                 {"skipped", one.skipped},
                 {"seconds", one.seconds},
                 {"detail", one.detail},
                 {"columns", Json::array()}};
    for (const ColumnResult& column : one.columns)
        json["columns"].push_back(to_json(column));
    return json;
}

CheckResult check_of(const Json& json) {
    CheckResult one;
    one.id = json.at("id");
    one.case_name = json.at("case");
    one.run = json.at("run");
    one.kind = json.at("kind");
    one.equation = json.at("equation");
    one.expected = json.at("expected");
    one.got = json.at("got");
    one.expected_number = optional_of<double>(json.at("expected_number"));
    one.got_number = optional_of<double>(json.at("got_number"));
    one.difference = json.at("difference");
    one.tolerance = json.at("tolerance");
    one.unit = json.at("unit");
    one.reason = json.at("reason");
    one.ok = true;
    one.skipped = json.at("skipped");
    one.seconds = json.at("seconds");
    one.detail = json.at("detail");
    one.kept = true;
    for (const Json& column : json.at("columns"))
        one.columns.push_back(column_of(column));
    return one;
}

fs::path file_of(const fs::path& folder) {
    return folder.string() + ".checks.json";
}

/// A deck that is refused leaves no folder: its checks depend on the key alone.
std::string digest_of_results(const fs::path& folder) {
    return fs::exists(folder) ? digest_of(folder) : "none";
}

}  // namespace

std::optional<std::vector<CheckResult>> kept_checks(const fs::path& folder, const std::string& key) {
    try {
        std::ifstream in(file_of(folder));
        if (!in) return std::nullopt;
        const Json kept = Json::parse(in);
        if (kept.at("key") != key || kept.at("results") != digest_of_results(folder)) return std::nullopt;
        std::vector<CheckResult> checks;
        for (const Json& one : kept.at("checks"))
            checks.push_back(check_of(one));
        return checks;
    } catch (const std::exception&) {
        return std::nullopt;  // damaged: as if there were none, the run is done again
    }
}

void keep_checks(const fs::path& folder, const std::string& key, const std::vector<CheckResult>& checks) {
    std::error_code error;
    fs::remove(file_of(folder), error);
    if (!std::all_of(checks.begin(), checks.end(), [](const CheckResult& one) { return one.ok; })) return;
    Json kept = {{"key", key}, {"results", digest_of_results(folder)}, {"checks", Json::array()}};
    for (const CheckResult& one : checks)
        kept["checks"].push_back(to_json(one));
    // A file that cannot be written, or a number that JSON does not have, costs a run the next time and nothing else.
    std::ofstream out(file_of(folder), std::ios::binary | std::ios::trunc);
    out << kept.dump(1, ' ', false, Json::error_handler_t::replace) << '\n';
}

}  // namespace type21
