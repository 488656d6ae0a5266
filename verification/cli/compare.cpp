#include <fstream>
#include <memory>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/criteria/cases/case_file.h"
#include "verification/results/compare/compare_file.h"
#include "verification/results/compare/comparison_text.h"
#include "verification/results/t01/t01_records.h"

namespace type21::cli {
namespace {

namespace fs = std::filesystem;

struct CompareArguments {
    std::string ours, reference, json;
    std::optional<double> tolerance;
    std::vector<std::string> columns;
};

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
    return comparison.ok() ? exit_ok : exit_mismatch;
}

/// A file that cannot be read is treated like a deck with errors: a message with the place, and exit code 2.
int compare_with_file(const CompareArguments& options) {
    try {
        return report(compare_file(options.ours, options.reference, {options.tolerance, options.columns, {}}), options);
    } catch (const T01Error& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const CsvError& error) {
        fmt::print(stderr, "{}\n", error.what());
    } catch (const UnclearReference& error) {
        throw UsageError(error.what());
    }
    return exit_deck;
}

int compare(const CompareArguments& options) {
    require_folder(options.ours);
    if (std::error_code error; fs::is_regular_file(options.reference, error)) return compare_with_file(options);
    require_folder(options.reference);
    FolderOptions folder_options{options.tolerance, options.columns, {}};
    bool foreign = false;
    const std::string as_built = as_built_of(options.ours);
    if (fs::exists(fs::path(options.reference) / "case.toml")) {
        std::vector<std::string> problems;
        const Case a_case = read_case(options.reference, problems);
        for (const std::string& problem : problems)
            fmt::print(stderr, "{}\n", problem);
        if (!problems.empty()) return exit_deck;
        folder_options.rules = rules_of(a_case, as_built, foreign);
    }
    const FolderComparison comparison = compare_folders(options.ours, options.reference, folder_options);
    const int code = report(comparison, options);
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
    verb->add_option("--json", options->json, "also write the output to this JSON file");
    verb->callback([options, &exit_code] { exit_code = compare(*options); });
}

}  // namespace type21::cli
