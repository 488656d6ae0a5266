/// @file The command line: adds the commands, and turns exceptions into exit codes.
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <filesystem>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"
#include "verification/results/record/result_folder.h"
#include "verification/support/build_info.h"
#include "verification/support/io_error.h"

namespace {

bool is_verb(CLI::App& app, const std::string& word) {
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
        if (verb->get_name() == word) return true;
    return false;
}

int run(int argc, char** argv) {
    using namespace type21;
    CLI::App app{"The TYPE21 stamping contact of Radioss as an executable specification.", "type21"};
    const BuildInfo& build = build_info();
    app.set_version_flag("--version", fmt::format("type21 {} ({}, {}, {})", build.version, build.commit, build.compiler,
                                                  build.build_type));
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 success; 1 wrong command line, or a folder or file that cannot be used; 2 errors in the deck;\n"
        "3 histories, decisions or implementations differ, or a criterion failed; 4 the run stopped or diverged, or "
        "an\n"
        "internal error; 5 a disk, a folder or a pipe did not take the output; 6 the run was interrupted by a signal.");
    int code = cli::exit_ok;
    cli::add_check(app, code);
    cli::add_run(app, code);
    cli::add_compare(app, code);
    cli::add_verify(app, code);
    cli::add_departures(app, code);
    cli::add_explain(app, code);
    cli::add_decide(app, code);
    cli::add_lockstep(app, code);
    cli::add_mutate(app, code);
    cli::add_stability(app, code);
    cli::add_accuracy(app, code);
    cli::add_laws(app, code);
    cli::add_atlas(app, code);
    cli::add_fuzz(app, code);
    cli::add_replay(app, code);
    cli::add_bench(app, code);
    if (argc <= 1) {
        fmt::print(stderr, "{}", app.help());
        return cli::exit_usage;
    }
    // The message of the parser would only be that a command is missing.
    if (const std::string word = argv[1]; !word.starts_with('-') && !is_verb(app, word)) {
        fmt::print(stderr, "type21: there is no command '{}'; 'type21 --help' lists the commands\n", word);
        return cli::exit_usage;
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& asked) {
        std::ostringstream text;
        code = app.exit(asked, text, text);  // --help, --version
        fmt::print("{}", text.str());
        return code;
    } catch (const CLI::ParseError& error) {
        fmt::print(stderr,
                   "type21: {}\n'type21 --help' lists the commands, 'type21 COMMAND --help' the options of one.\n",
                   error.what());
        return cli::exit_usage;
    }
    return code;
}

/// Never throws, so that no exception leaves the handlers of main.
int complain(const char* what, const std::exception& error, int code) {
    std::fputs(what, stderr);
    std::fputs(error.what(), stderr);
    std::fputs("\n", stderr);
    return code;
}

/// Output that a stream did not take is an error of its own, if nothing else has failed.
/// @param code   of the command
/// @param error  errno where a stream has failed before
int checked_streams(int code, int error) {
    for (const auto& [stream, name] : {std::pair{stdout, "stdout"}, std::pair{stderr, "stderr"}}) {
        errno = 0;
        const bool failed = std::fflush(stream) != 0;
        const int reason = failed && errno != 0 ? errno : error;
        if (!failed && std::ferror(stream) == 0) continue;
        if (stream == stdout)
            std::fprintf(stderr, "type21: %s: cannot be written: %s\n", name,
                         reason != 0 ? std::strerror(reason) : "the output is not whole");
        if (code == type21::cli::exit_ok) code = type21::cli::exit_io;
    }
    return code;
}

int guarded(int argc, char** argv) {
    using namespace type21;
    try {
        return checked_streams(run(argc, argv), 0);
    } catch (const cli::UsageError& error) {
        return complain("type21: ", error, cli::exit_usage);
    } catch (const FolderError& error) {
        return complain("type21: ", error, cli::exit_usage);
    } catch (const IoError& error) {
        return complain("type21: ", error, cli::exit_io);
    } catch (const std::filesystem::filesystem_error& error) {
        return complain("type21: ", IoError(error.path1(), "cannot be read or written", error.code().value()),
                        cli::exit_io);
    } catch (const std::system_error& error) {
        if (std::ferror(stdout) != 0 || std::ferror(stderr) != 0)
            return checked_streams(cli::exit_ok, error.code().value());
        return complain("type21: internal error: ", error, cli::exit_stopped);
    } catch (const std::exception& error) {
        return complain("type21: internal error: ", error, cli::exit_stopped);
    }
}

}  // namespace

int main(int argc, char** argv) {
    // A closed pipe is an error of the write, and the program lives to say so.
    std::signal(SIGPIPE, SIG_IGN);
    return guarded(argc, argv);
}
