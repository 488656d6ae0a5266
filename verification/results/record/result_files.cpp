#include "verification/results/record/result_files.h"

#include <fstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "verification/results/record/run_id.h"
#include "verification/support/io_error.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

bool is_file(const fs::path& path) {
    std::error_code error;
    return fs::is_regular_file(fs::symlink_status(path, error));
}

bool is_folder(const fs::path& path) {
    std::error_code error;
    return fs::is_directory(fs::symlink_status(path, error));
}

bool matches(const std::string& name, std::string_view begin, std::string_view end) {
    return name.size() >= begin.size() + end.size() && name.starts_with(begin) && name.ends_with(end);
}

bool is_csv(const std::string& name) {
    return name == "nodes.csv" || name == "rbody.csv" || matches(name, "interface_", ".csv") ||
           matches(name, "skid_line_", ".csv") || matches(name, "adaptive_", ".csv");
}

bool is_checkpoint(const std::string& name) {
    return matches(name, "checkpoint", ".t21");
}

bool is_for_paraview(const std::string& name) {
    return (name.starts_with("blank_") || name.starts_with("tool_")) &&
           (name.ends_with(".pvd") || name.ends_with(".vtu"));
}

/// Left by a run that was killed while it replaced a file.
bool is_unfinished(const std::string& name) {
    return name.ends_with(".new") && (name.starts_with("run.json.") || name.starts_with("checkpoint") ||
                                      name.starts_with("blank_") || name.starts_with("tool_"));
}

/// @throws IoError
std::vector<fs::path> entries(const fs::path& folder) {
    std::error_code error;
    std::vector<fs::path> found;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        found.push_back(entry->path());
    if (error) throw IoError(folder, "cannot be read", error.value());
    return found;
}

template <class Belongs>
std::vector<fs::path> files_in(const fs::path& folder, const Belongs& belongs) {
    std::vector<fs::path> found;
    if (!is_folder(folder)) return found;
    for (const fs::path& path : entries(folder))
        if (is_file(path) && belongs(path.filename().string())) found.push_back(path);
    return found;
}

}  // namespace

std::optional<RunMark> read_run_mark(const fs::path& folder) {
    const fs::path path = folder / "run.json";
    if (!is_file(path)) return std::nullopt;
    std::ifstream file(path);
    const auto json = nlohmann::json::parse(file, nullptr, false);
    const auto text = [&](const char* key) {
        return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
    };
    if (!json.is_object() || text("program") != "type21") return std::nullopt;
    return RunMark{text("run_id"), text("status")};
}

std::vector<fs::path> marked_files(const fs::path& folder) {
    std::vector<fs::path> found = files_in(folder, is_csv);
    for (fs::path& path : files_in(folder / "paraview", is_for_paraview))
        found.push_back(std::move(path));
    return found;
}

std::vector<fs::path> checkpoints_in(const fs::path& folder) {
    return files_in(folder, is_checkpoint);
}

std::string foreign_content(const fs::path& folder) {
    const std::optional<RunMark> run = read_run_mark(folder);
    for (const fs::path& path : entries(folder)) {
        const std::string name = path.filename().string();
        if (name == "paraview" && is_folder(path)) {
            for (const fs::path& inner : entries(path)) {
                const std::string inner_name = inner.filename().string();
                if (!is_file(inner) || !(is_for_paraview(inner_name) || is_unfinished(inner_name)))
                    return fmt::format("{}: is not of a run", inner.string());
            }
            continue;
        }
        const bool ours = name == "run.json" || is_csv(name) || is_checkpoint(name) || is_unfinished(name);
        if (!ours || !is_file(path)) return fmt::format("{}: is not of a run", path.string());
        if (!run) return fmt::format("{}: no run.json says that a run wrote it", path.string());
        if (is_csv(name) && !run->run_id.empty() && run_id_in(path).empty())
            return fmt::format("{}: its last line does not say that a run wrote it", path.string());
    }
    return "";
}

bool remove_result(const fs::path& folder) {
    std::error_code error;
    for (const fs::path& path :
         files_in(folder / "paraview", [](const std::string& n) { return is_for_paraview(n) || is_unfinished(n); }))
        fs::remove(path, error);
    if (is_folder(folder / "paraview")) fs::remove(folder / "paraview", error);
    for (const fs::path& path :
         files_in(folder, [](const std::string& n) { return is_csv(n) || is_checkpoint(n) || is_unfinished(n); }))
        fs::remove(path, error);
    // Last, so that what is left of a removal that is cut short is still known to be ours.
    if (is_file(folder / "run.json")) fs::remove(folder / "run.json", error);
    fs::remove(folder, error);
    return !fs::exists(fs::symlink_status(folder, error));
}

}  // namespace type21
