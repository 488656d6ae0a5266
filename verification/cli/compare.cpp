#include <charconv>
#include <cmath>
#include <fstream>
#include <memory>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/criteria/cases/case_file.h"
#include "verification/report/comparison_junit.h"
#include "verification/results/compare/compare_file.h"
#include "verification/results/compare/comparison_text.h"
#include "verification/results/record/run_id.h"
#include "verification/results/t01/t01_records.h"

namespace type21::cli {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
    std::string ours, reference, json, junit;
    std::optional<double> tolerance, time_scale, until;
    std::vector<std::string> columns, map, scale;
    bool unfinished = false;
};

/// "FNX=Force X" at its first '='.
std::pair<std::string, std::string> split_pair(const std::string& option, const std::string& text) {
    const size_t equal = text.find('=');
    if (equal == std::string::npos || equal == 0 || equal + 1 == text.size())
        throw UsageError(
            fmt::format("{} {}: write {}", option, text,
                        option == "--map" ? "OURS=THEIRS, such as FNX='Force X'" : "COLUMN=FACTOR, such as FNX=1000"));
    return {text.substr(0, equal), text.substr(equal + 1)};
}

double factor_in(const std::string& text, const std::string& where) {
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value) || value == 0)
        throw UsageError(fmt::format("{}: '{}' is not a finite number other than 0", where, text));
    return value;
}

FolderOptions folder_options(const CompareArguments& options) {
    FolderOptions out;
    out.tolerance = options.tolerance;
    out.columns = options.columns;
    out.until = options.until;
    for (const std::string& text : options.map)
        out.changes.map.push_back(split_pair("--map", text));
    for (const std::string& text : options.scale) {
        const auto [column, factor] = split_pair("--scale", text);
        out.changes.scale.emplace_back(column, factor_in(factor, "--scale " + text));
    }
    if (options.time_scale && !(*options.time_scale > 0 && std::isfinite(*options.time_scale)))
        throw UsageError(fmt::format("--time-scale {}: write a number larger than 0", *options.time_scale));
    if (options.until && !std::isfinite(*options.until))
        throw UsageError(fmt::format("--until {}: write a time", *options.until));
    out.changes.time_scale = options.time_scale;
    return out;
}

void require_folder(const std::string& folder) {
    std::error_code error;
    if (!fs::is_directory(folder, error)) throw UsageError(fmt::format("{}: is not a folder that can be read", folder));
}

/// "D04, D24" or "none"; empty if the folder has no run.json with that entry.
std::string as_built_of(const fs::path& folder) {
    std::ifstream file(folder / "run.json");
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object() || !json.contains("as_built") || !json["as_built"].is_string()) return "";
    return json["as_built"];
}

int report(const FolderComparison& comparison, const CompareArguments& options) {
    fmt::print("{}", to_text(comparison));
    if (!options.json.empty()) write_report(options.json, to_json(comparison));
    if (!options.junit.empty()) write_report(options.junit, comparison_junit(comparison));
    return comparison.ok() ? exit_ok : exit_mismatch;
}

/// A file that cannot be read is treated like a deck with errors: a message with the place, and exit code 2.
int compare_with_file(const CompareArguments& options) {
    try {
        return report(compare_file(options.ours, options.reference, folder_options(options)), options);
    } catch (const T01Error& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const CsvError& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const UnclearReference& error) {
        throw UsageError(error.what());
    } catch (const WrongOption& error) {
        throw UsageError(error.what());
    }
    return exit_deck;
}

FolderComparison folders_compared(const CompareArguments& options, const FolderOptions& settings) {
    try {
        return compare_folders(options.ours, options.reference, settings);
    } catch (const WrongOption& error) {
        throw UsageError(error.what());
    }
}

/// Says on stderr why the files of a folder are not those of one run that has reached its end.
bool is_one_finished_run(const std::string& folder, bool unfinished) {
    const RunFolderCheck check = check_run_id(folder);
    for (const std::string& problem : check.problems)
        fmt::print(stderr, "{}\n", problem);
    if (!check.is_run || check.finished()) return check.problems.empty();
    if (unfinished)
        fmt::print(stderr, "note: {}: the run has not reached its end: it is {}\n", folder, check.status);
    else
        fmt::print(stderr,
                   "{}: the run has not reached its end: it is {}. Give --unfinished to compare what is there\n",
                   folder, check.status);
    return check.problems.empty() && unfinished;
}

int compare(const CompareArguments& options) {
    require_folder(options.ours);
    bool sound = is_one_finished_run(options.ours, options.unfinished);
    if (std::error_code error; fs::is_directory(options.reference, error))
        sound = is_one_finished_run(options.reference, options.unfinished) && sound;
    if (!sound) return exit_deck;
    if (std::error_code error; fs::exists(options.reference, error) && !fs::is_directory(options.reference, error))
        return compare_with_file(options);
    require_folder(options.reference);
    FolderOptions settings = folder_options(options);
    bool foreign = false;
    const std::string as_built = as_built_of(options.ours);
    if (fs::exists(fs::path(options.reference) / "case.toml")) {
        std::vector<std::string> problems;
        const Case a_case = read_case(options.reference, problems);
        for (const std::string& problem : problems)
            fmt::print(stderr, "{}\n", problem);
        if (!problems.empty()) return exit_deck;
        settings.rules = rules_of(a_case, as_built, foreign);
    }
    const int code = report(folders_compared(options, settings), options);
    if (foreign && !as_built.empty())
        fmt::print(
            "note: {} was run with the departures '{}'; the criteria of the case are for other departures (see "
            "--as-built and its case.toml)\n",
            options.ours, as_built);
    return code;
}

}  // namespace

void add_compare(CLI::App& app, int& exit_code) {
    CLI::App* verb = app.add_subcommand(
        "compare",
        "Compare the histories of a run with another run, a case, an OpenRadioss time-history file or a CSV");
    const auto options = std::make_shared<CompareArguments>();
    verb->add_option("OURS", options->ours, "folder of a run")->required();
    verb->add_option("REFERENCE", options->reference,
                     "folder of another run or of a case, a time-history file of OpenRadioss (NAMET01), or a CSV with "
                     "the columns of a run")
        ->required();
    verb->add_option(
            "--tolerance", options->tolerance,
            "allowed difference relative to the scale of the column (default: that of the case, otherwise 1e-9)")
        ->check(CLI::NonNegativeNumber);
    verb->add_option("--columns", options->columns, "compare only these columns, such as FNX,FNZ (default: all)")
        ->delimiter(',');
    verb->add_option(
            "--map", options->map,
            "OURS=THEIRS: our column and the reference's header for it, such as FNX='Force X'; may be repeated")
        ->allow_extra_args(false);
    verb->add_option("--scale", options->scale,
                     "COLUMN=FACTOR: multiply a column of the reference, such as FNX=1000; may be repeated")
        ->allow_extra_args(false);
    verb->add_option("--time-scale", options->time_scale, "multiply the times of the reference by this");
    verb->add_option("--until", options->until, "compare up to this time [time of the run]");
    verb->add_flag("--unfinished", options->unfinished,
                   "compare also a run that stopped or was interrupted before its end");
    verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->add_option("--junit", options->junit, "also write JUnit XML to this file: one test for each column");
    verb->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace type21::cli
