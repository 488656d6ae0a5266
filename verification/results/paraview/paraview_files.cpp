#include "verification/results/paraview/paraview_files.h"

#include <cerrno>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "verification/support/io_error.h"
#include "verification/support/output_file.h"

namespace type21 {
namespace fs = std::filesystem;

ParaviewFiles::ParaviewFiles(const HostScene& scene, const fs::path& folder, const std::string& mark)
    : folder_(folder / "paraview"), mark_(mark), clock_(scene.host->engine.history_interval) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error) throw IoError(folder_, "cannot be created", error.value());
    for (size_t i = 0; i < scene.model->interfaces.size(); ++i) {
        const Id id = scene.model->interfaces[i].id;
        grids_.emplace_back(scene, static_cast<int>(i));
        for (auto& [series, what] :
             {std::pair<std::vector<Series>&, const char*>{blanks_, "blank"}, {tools_, "tool"}}) {
            const std::string name = fmt::format("{}_{}", what, id);
            series.push_back({name, PvdFile(folder_ / (name + ".pvd"), mark)});
        }
    }
}

void ParaviewFiles::observe(const CycleRecord& record) {
    for (ContactGrid& grid : grids_)
        grid.add(record);
    if (!clock_.due(record.time, record.step, record.last)) return;
    for (size_t i = 0; i < grids_.size(); ++i) {
        add(blanks_[i], grids_[i].blank(record));
        add(tools_[i], grids_[i].tool(record));
    }
    times_.push_back(record.time);
}

std::string ParaviewFiles::Series::file(size_t number) const {
    return fmt::format("{}_{:06}.vtu", name, number);
}

void ParaviewFiles::add(Series& series, const VtuGrid& grid) {
    const std::string file = series.file(times_.size());
    write_vtu(folder_ / file, grid, mark_);
    series.list.add(grid.time, file);
}

void ParaviewFiles::take_over(const fs::path& folder, const std::vector<double>& times) {
    for (std::vector<Series>* all : {&blanks_, &tools_}) {
        for (Series& series : *all) {
            for (size_t i = 0; i < times.size(); ++i) {
                const std::string name = series.file(i);
                const fs::path from = folder / "paraview" / name;
                errno = 0;
                std::ifstream file(from, std::ios::binary);
                std::string first, mark;
                std::getline(file, first);
                std::getline(file, mark);
                const std::string rest{std::istreambuf_iterator<char>(file), {}};
                if (!file) throw IoError(from, "cannot be read", errno);
                replace_file(folder_ / name, first + "\n" + mark_ + rest);
                series.list.add(times[i], name);
            }
        }
    }
    times_ = times;
}

}  // namespace type21
