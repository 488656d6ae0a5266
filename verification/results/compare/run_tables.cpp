#include "verification/results/compare/run_tables.h"

#include <charconv>

#include <fmt/format.h>

#include "verification/support/json_file.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

std::optional<UnitSystem> units_in(const nlohmann::json& run) {
    const auto units = run.find("units");
    if (units == run.end() || !units->is_object()) return std::nullopt;
    const auto word = [&](const char* key) {
        const auto found = units->find(key);
        return found != units->end() && found->is_string() ? found->get<std::string>() : std::string();
    };
    UnitSystem out;
    out.mass_name = word("mass");
    out.length_name = word("length");
    out.time_name = word("time");
    out.mass = mass_unit(out.mass_name);
    out.length = length_unit(out.length_name);
    out.time = time_unit(out.time_name);
    if (out.mass > 0 && out.length > 0 && out.time > 0) return out;
    return std::nullopt;
}

}  // namespace

std::string interface_file(Id interface) {
    return fmt::format("interface_{}.csv", interface);
}

std::optional<Id> interface_of(std::string_view file) {
    constexpr std::string_view before = "interface_", behind = ".csv";
    if (!file.starts_with(before) || !file.ends_with(behind)) return std::nullopt;
    file = file.substr(before.size(), file.size() - before.size() - behind.size());
    Id id = 0;
    const auto [end, error] = std::from_chars(file.data(), file.data() + file.size(), id);
    if (error != std::errc{} || end != file.data() + file.size()) return std::nullopt;
    return id;
}

RunTables::RunTables(fs::path folder) : folder_(std::move(folder)) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_))
        if (const auto id = interface_of(entry.path().filename().string())) interfaces_.insert(*id);
    if (!has("run.json")) return;
    std::vector<std::string> ignored;  // a damaged run.json has no units to offer
    const std::optional<nlohmann::json> run = read_json(folder_ / "run.json", ignored);
    if (!run || !run->is_object()) return;
    units_ = units_in(*run);
    const auto interfaces = run->find("interfaces");
    if (interfaces == run->end() || !interfaces->is_array()) return;
    for (const nlohmann::json& interface : *interfaces)
        if (interface.is_object() && interface.contains("id") && interface["id"].is_number_integer() &&
            interface.contains("title") && interface["title"].is_string())
            titles_[interface["id"].get<Id>()] = interface["title"].get<std::string>();
}

const CsvTable& RunTables::table(const std::string& file) {
    const auto found = tables_.find(file);
    return found != tables_.end() ? found->second : tables_.emplace(file, read_csv(folder_ / file)).first->second;
}

const std::set<Id>& RunTables::objects(const std::string& file) {
    const auto [found, is_new] = objects_.try_emplace(file);
    if (is_new && has(file)) {
        const CsvTable& read = table(file);
        found->second.insert(read.object.begin(), read.object.end());
    }
    return found->second;
}

const std::vector<std::string>& RunTables::columns(const std::string& file) {
    static const std::vector<std::string> none;
    return has(file) ? table(file).columns : none;
}

}  // namespace type21
