#include "verification/performance/bench/reading.h"

#include <chrono>
#include <filesystem>
#include <stdexcept>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>

#include "reference/host/prepare_deck.h"

namespace type21::bench {

namespace {

namespace fs = std::filesystem;

/// A folder that is gone at the end.
class ShortLivedFolder {
  public:
    ShortLivedFolder() {
        std::string pattern = (fs::temp_directory_path() / "type21_reading_XXXXXX").string();
        if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("bench: no temporary folder");
        path_ = pattern;
    }
    ~ShortLivedFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    ShortLivedFolder(const ShortLivedFolder&) = delete;
    ShortLivedFolder& operator=(const ShortLivedFolder&) = delete;
    const std::string& path() const { return path_; }

  private:
    std::string path_;
};

/// What the reading process tells the one that waits for it.
struct Told {
    std::size_t nodes = 0, shells = 0;
};

/// The child's part: nothing of the parent is used but the path.
[[noreturn]] void read_and_tell(const std::string& path, int pipe) {
    const PreparedDeck deck = prepare_deck(path, "", true);
    const Told told = deck.scene ? Told{deck.scene->model->nodes.id.size(), deck.scene->model->shells.size()} : Told{};
    const bool written = write(pipe, &told, sizeof told) == static_cast<ssize_t>(sizeof told);
    _exit(written && deck.scene ? 0 : 1);
}

double seconds_of(const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ReadingRow measure_reading(int nodes) {
    const ShortLivedFolder folder;
    const std::string path = write_large_deck(folder.path(), nodes);
    ReadingRow row;
    row.bytes = fs::file_size(path);
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("bench: no pipe");
    const pid_t child = fork();
    if (child == 0) read_and_tell(path, ends[1]);
    close(ends[1]);
    Told told;
    const bool heard = child > 0 && read(ends[0], &told, sizeof told) == static_cast<ssize_t>(sizeof told);
    close(ends[0]);
    int status = 0;
    rusage usage{};
    if (child > 0) wait4(child, &status, 0, &usage);
    if (!heard || status != 0 || told.nodes == 0) throw std::runtime_error("bench: the large deck was not read");
    row.nodes = told.nodes;
    row.shells = told.shells;
    row.seconds = seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
    row.peak_bytes_per_node = 1024.0 * static_cast<double>(usage.ru_maxrss) / static_cast<double>(told.nodes);
    return row;
}

std::string to_text(const std::vector<ReadingRow>& rows) {
    std::string out = rows.empty() ? "" : "\nreading a deck\n";
    for (const ReadingRow& row : rows)
        out += fmt::format(
            "  {} nodes, {} shells, {:.1f} MB: {:.2f} s of one processor, {:.0f} MB/s, {:.0f} B per node\n", row.nodes,
            row.shells, static_cast<double>(row.bytes) / 1e6, row.seconds, row.rate(), row.peak_bytes_per_node);
    return out;
}

nlohmann::ordered_json to_json(const std::vector<ReadingRow>& rows) {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const ReadingRow& row : rows)
        out.push_back({{"nodes", row.nodes},
                       {"shells", row.shells},
                       {"bytes", row.bytes},
                       {"seconds", row.seconds},
                       {"mb_per_second", row.rate()},
                       {"peak_bytes_per_node", row.peak_bytes_per_node}});
    return out;
}

std::vector<Target> reading_targets(const ReadingRow& row) {
    const std::string size = fmt::format("a deck of {} nodes", row.nodes);
    if (row.nodes < 500000) return {};  // the program itself takes more than a small deck
    return {{"reading " + size, "reading", "MB/s", Better::higher, 100, 200, row.rate(), "up to the scene that runs"},
            {"memory of reading " + size, "reading", "B per node", Better::lower, 300, 250, row.peak_bytes_per_node,
             "largest resident memory"}};
}

}  // namespace type21::bench
