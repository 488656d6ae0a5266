#include "verification/results/paraview/paraview_files.h"

#include <fmt/format.h>

namespace type21 {
namespace fs = std::filesystem;

ParaviewFiles::ParaviewFiles(const HostScene& scene, const fs::path& folder)
    : folder_(folder / "paraview"), clock_(scene.host->engine.history_interval) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw std::runtime_error(fmt::format("{}: cannot be created: {}", folder_.string(), error.message()));
    for (size_t i = 0; i < scene.model->interfaces.size(); ++i) {
        const Id id = scene.model->interfaces[i].id;
        grids_.emplace_back(scene, static_cast<int>(i));
        for (auto& [series, what] :
             {std::pair<std::vector<Series>&, const char*>{blanks_, "blank"}, {tools_, "tool"}}) {
            const std::string name = fmt::format("{}_{}", what, id);
            series.push_back({name, PvdFile(folder_ / (name + ".pvd"))});
        }
    }
}

void ParaviewFiles::observe(const CycleRecord& record) {
    for (ContactGrid& grid : grids_)
        grid.add(record);
    if (!clock_.due(record.time, record.step, record.last)) return;
    for (size_t i = 0; i < grids_.size(); ++i) {
        blanks_[i].add(folder_, written_, grids_[i].blank(record));
        tools_[i].add(folder_, written_, grids_[i].tool(record));
    }
    ++written_;
}

void ParaviewFiles::Series::add(const fs::path& folder, long number, const VtuGrid& grid) {
    const std::string file = fmt::format("{}_{:06}.vtu", name, number);
    write_vtu(folder / file, grid);
    list.add(grid.time, file);
}

std::vector<fs::path> old_paraview_files(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator entry(folder / "paraview", error), end; !error && entry != end;
         entry.increment(error)) {
        const fs::path& path = entry->path();
        const std::string name = path.filename().string();
        const bool ours = name.starts_with("blank_") || name.starts_with("tool_");
        if (ours && (path.extension() == ".pvd" || path.extension() == ".vtu")) files.push_back(path);
    }
    return files;
}

}  // namespace type21
