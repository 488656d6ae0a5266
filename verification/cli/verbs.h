/// @file The commands of type21. Each adds its options to the program and a callback that sets the exit code.
#pragma once

#include <CLI/CLI.hpp>

#include "reference/deck/problem.h"
#include "reference/host/march.h"

namespace type21::cli {

void add_check(CLI::App& app, int& exit_code);
void add_run(CLI::App& app, int& exit_code);
void add_compare(CLI::App& app, int& exit_code);
void add_verify(CLI::App& app, int& exit_code);
void add_departures(CLI::App& app, int& exit_code);
void add_explain(CLI::App& app, int& exit_code);
void add_decide(CLI::App& app, int& exit_code);
void add_lockstep(CLI::App& app, int& exit_code);
void add_mutate(CLI::App& app, int& exit_code);
void add_stability(CLI::App& app, int& exit_code);
void add_accuracy(CLI::App& app, int& exit_code);
void add_laws(CLI::App& app, int& exit_code);
void add_atlas(CLI::App& app, int& exit_code);
void add_fuzz(CLI::App& app, int& exit_code);
void add_replay(CLI::App& app, int& exit_code);
void add_bench(CLI::App& app, int& exit_code);

/// The option --as-built; a wrong set is a usage error.
void add_as_built(CLI::App& verb, std::string& as_built);

/// The option --search, without a default. @param also  goes on with the words of --help
void add_search(CLI::App& verb, std::string& search, const std::string& also);

/// contact_maker() of --with and --search.
/// @throws UsageError where a search is chosen for the reference
MakeContact chosen_contact(const std::string& with, const std::string& search);

/// Prints every problem on stderr, in the order of the deck, and their number.
void print_problems(const Problems& problems);

}  // namespace type21::cli
