#include "verification/performance/bench/bench.h"

#include <chrono>
#include <cstdio>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reference/host/prepare_deck.h"
#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/performance/bench/reading.h"

namespace type21::cli {
namespace {

struct BenchArguments {
    std::string deck, json;
    std::vector<std::string> sizes, nodes, reading;
    std::vector<int> threads{1, 2};
    std::string check = "200k";
    int cycles = 200;
    bool quick = false, quiet = false;
};

std::vector<int> counts(const char* option, const std::vector<std::string>& words, int low, int high) {
    std::vector<int> out;
    for (const std::string& word : words) {
        try {
            out.push_back(bench::count_of(word, low, high));
        } catch (const std::invalid_argument& error) {
            throw UsageError(fmt::format("{}: {}", option, error.what()));
        }
    }
    return out;
}

/// Before anything else, as a process has the memory of the one that it comes from.
std::vector<bench::ReadingRow> read_decks(const BenchArguments& options,
                                          const std::function<void(const std::string&)>& progress) {
    std::vector<bench::ReadingRow> rows;
    for (const int nodes : counts("--reading", options.reading, 1000, 10000000)) {
        progress(fmt::format("reading a deck of {} nodes", nodes));
        rows.push_back(bench::measure_reading(nodes));
    }
    return rows;
}

int run(const BenchArguments& options, const std::string& command) {
    bench::BenchOptions bench;
    bench.quick = options.quick;
    const bool generated = options.deck.empty() || !options.sizes.empty();
    if (generated) {
        bench.sizes = counts("--sizes", options.sizes, 1000, 4000000);
        if (bench.sizes.empty()) bench.sizes = {20000, 200000};
        if (options.sizes.empty() && !options.quick) bench.sizes.push_back(1000000);
    }
    bench.nodes = counts("--nodes", options.nodes, 1000, 4000000);
    if (options.nodes.empty() && !options.quick) bench.nodes = {10000, 1000000};
    bench.threads = options.threads;
    bench.check = counts("--check", {options.check}, 0, 1000000000).front();
    bench.deck_cycles = options.cycles;
    if (!options.deck.empty()) {
        PreparedDeck prepared = prepare_deck(options.deck, "", true);
        print_problems(prepared.problems);
        if (!prepared.scene) return exit_deck;
        bench.deck = std::move(prepared.scene);
    }
    if (!options.quiet) {
        const auto start = std::chrono::steady_clock::now();
        bench.progress = [start](const std::string& what) {
            const double now = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
            fmt::print(stderr, "{:6.1f} s  {}\n", now, what);
            std::fflush(stderr);
        };
    }
    const std::vector<bench::ReadingRow> reading = read_decks(options, bench.progress);
    bench::BenchResult result = bench::run_bench(bench);
    result.command = command;
    for (const bench::ReadingRow& row : reading) {
        for (bench::Target& target : bench::reading_targets(row))
            result.targets.push_back(std::move(target));
    }
    fmt::print("{}{}", bench::to_text(result), bench::to_text(reading));
    if (!options.json.empty()) {
        nlohmann::ordered_json json = bench::to_json(result);
        json["reading"] = bench::to_json(reading);
        write_report(options.json, json);
    }
    return result.different() == 0 ? exit_ok : exit_mismatch;
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "bench",
        "Measure the speed of the optimized contact and of other searches on this machine, and check its decisions");
    const auto options = std::make_shared<BenchArguments>();
    verb->add_option(
        "DECK", options->deck,
        "starter deck NAME_0000.rad to time instead of the generated scenes (with --sizes: as well as them)");
    verb->add_option("--sizes", options->sizes,
                     "numbers of triangles of the stamped pan (default: 20k,200k,1M; with --quick: 20k,200k)")
        ->delimiter(',');
    verb->add_option("--nodes", options->nodes,
                     "further numbers of nodes above the pan (default: 10k,1M; with --quick: none)")
        ->delimiter(',');
    verb->add_option("--reading", options->reading,
                     "numbers of nodes of decks that are written, and read in a process of their own (default: none)")
        ->delimiter(',');
    verb->add_option("--threads", options->threads, "numbers of threads to compare; everything else uses one thread")
        ->delimiter(',')
        ->check(CLI::Range(1, 256))
        ->capture_default_str();
    verb->add_option("--check", options->check, "number of decisions to compare with exact ones")
        ->capture_default_str();
    verb->add_option("--cycles", options->cycles, "largest number of cycles of DECK")
        ->check(CLI::Range(3, 100000))
        ->capture_default_str();
    verb->add_flag("--quick", options->quick, "smaller tools and fewer repeats: about half a minute");
    verb->add_option("--json", options->json,
                     "also write the output to this JSON file (the report reads build/report/bench.json)");
    verb->add_flag("--quiet", options->quiet, "print no progress");
    verb->footer(
        "Ratios compare the medians of methods that are timed in turn. \n"
        "Exit code 3 if a decision is not exact; 'type21 --help' lists the others.");
    verb->callback([options, &exit_code] {
        std::string command = "type21 bench";
        const auto add = [&](const std::string& text) { command += " " + text; };
        if (!options->deck.empty()) add(options->deck);
        if (options->quick) add("--quick");
        if (!options->sizes.empty()) add(fmt::format("--sizes {}", fmt::join(options->sizes, ",")));
        if (!options->nodes.empty()) add(fmt::format("--nodes {}", fmt::join(options->nodes, ",")));
        if (!options->reading.empty()) add(fmt::format("--reading {}", fmt::join(options->reading, ",")));
        if (options->check != "200k") add("--check " + options->check);
        exit_code = run(*options, command);
    });
}

}  // namespace type21::cli
