#include "verification/results/record/result_folder.h"

#include <fstream>
#include <vector>

#include <fmt/format.h>

#include "verification/results/paraview/paraview_files.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

bool is_result(const std::string& name) {
    return name == "nodes.csv" || name == "rbody.csv" || (name.starts_with("interface_") && name.ends_with(".csv"));
}

}  // namespace

void prepare_folder(const fs::path& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        throw FolderError(fmt::format("{}: is a file, not a folder. Choose another --out", folder.string()));
    fs::create_directories(folder, error);
    if (error) throw FolderError(fmt::format("{}: cannot be created: {}", folder.string(), error.message()));

    const bool ours = fs::exists(folder / "run.json", error);
    std::vector<fs::path> old;
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
        if (is_result(entry->path().filename().string())) old.push_back(entry->path());
    if (error) throw FolderError(fmt::format("{}: cannot be read: {}", folder.string(), error.message()));
    for (fs::path& path : old_paraview_files(folder))
        old.push_back(std::move(path));
    if (!ours && !old.empty())
        throw FolderError(fmt::format(
            "{}: already there and no run.json says that a run wrote it. Choose another --out", old.front().string()));
    // The trial comes before the removal: a folder that takes no new result keeps the old one.
    const fs::path trial = folder / "run.json.new";
    if (!std::ofstream(trial)) throw FolderError(fmt::format("{}: cannot be written", folder.string()));
    fs::remove(trial, error);
    for (const fs::path& path : old)
        fs::remove(path, error);
    if (ours) fs::remove(folder / "run.json", error);
    if (std::error_code none; fs::is_empty(folder / "paraview", none)) fs::remove(folder / "paraview", none);
    if (error)
        throw FolderError(fmt::format("{}: an earlier result cannot be removed: {}", folder.string(), error.message()));
}

}  // namespace type21
