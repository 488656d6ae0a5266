#include "reference/model/as_built_option.h"

#include "reference/contract/departures.h"
#include "verification/cli/verbs.h"

namespace type21::cli {
namespace {

/// Empty if the text names a set of departures, otherwise what is wrong.
std::string departures_trouble(const std::string& text) {
    Problems problems;
    parse_as_built(text, problems);
    std::string trouble;
    for (const Problem& problem : problems.list())
        trouble += (trouble.empty() ? "" : "\n") + to_text(problem);
    return trouble;
}

}  // namespace

void add_as_built(CLI::App& verb, std::string& as_built) {
    verb.add_option(
            "--as-built", as_built,
            "departures to switch on, such as all or D03,D24 or all,-D04 (default: none; see 'type21 departures')")
        ->check(CLI::Validator(departures_trouble, "SET"));
}

}  // namespace type21::cli
