// How a run ends when something from outside ends it: signals, disks, pipes, other runs.
#include <chrono>
#include <csignal>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/results/record/run_id.h"
#include "verification/results/tables/csv_table.h"
#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::DeckCopy;
using test::in_quotes;
using test::Outcome;
using test::read_text;
using test::TempFolder;
using test::without_mark;
namespace fs = std::filesystem;

/// The program in a process of its own.
class Process {
  public:
    Process(std::vector<std::string> arguments, const fs::path& err) : child_(fork()) {
        if (child_ != 0) return;
        const int out = open("/dev/null", O_WRONLY), error = open(err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
        dup2(out, STDOUT_FILENO);
        dup2(error, STDERR_FILENO);
        std::vector<char*> words{const_cast<char*>(TYPE21_BINARY)};
        for (std::string& argument : arguments)
            words.push_back(argument.data());
        words.push_back(nullptr);
        execv(TYPE21_BINARY, words.data());
        _exit(127);
    }
    ~Process() {
        if (!ended_) end(SIGKILL);
    }
    Process(const Process&) = delete;
    Process& operator=(const Process&) = delete;

    void signal(int number) const { kill(child_, number); }
    /// @return exit code, or minus the signal that killed it
    int wait() {
        int status = 0;
        waitpid(child_, &status, 0);
        ended_ = true;
        return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
    }
    int end(int number) {
        signal(number);
        return wait();
    }

  private:
    pid_t child_;
    bool ended_ = false;
};

/// The folder that a run into `target` writes; empty while there is none.
fs::path partial_of(const fs::path& target) {
    for (const fs::directory_entry& entry : fs::directory_iterator(target.parent_path()))
        if (entry.path().extension() == ".partial") return entry.path();
    return {};
}

/// Waits until `there` holds, ten seconds at most on a machine that does nothing else; a minute here.
template <class Condition>
bool wait_for(const Condition& there) {
    for (int i = 0; i < 6000; ++i) {
        if (there()) return true;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    return false;
}

/// A run that goes on, with at least one row of its histories on the disk.
struct GoingOn {
    DeckCopy deck;
    TempFolder messages;
    std::unique_ptr<Process> process;

    explicit GoingOn(const std::vector<std::string>& more = {}) : deck("flat_press") {
        const std::string text = read_text(deck.engine);
        const size_t line = text.find('\n', text.find("/RUN/")) + 1;
        test::write_text(deck.engine,
                         text.substr(0, line) + "                 1e3" + text.substr(text.find('\n', line)));
        std::vector<std::string> arguments{"run", deck.starter.string(), "--out", deck.out(), "--quiet"};
        arguments.insert(arguments.end(), more.begin(), more.end());
        process = std::make_unique<Process>(arguments, err());
    }
    fs::path err() const { return messages / "err"; }
    bool writes() const {
        return wait_for([&] {
            const fs::path partial = partial_of(deck.out());
            std::error_code error;
            return !partial.empty() && fs::file_size(partial / "interface_1.csv", error) > 1000 && !error;
        });
    }
    nlohmann::json run_json() const { return nlohmann::json::parse(read_text(fs::path(deck.out()) / "run.json")); }
};

/// The exit code of a script.
int bash(const TempFolder& folder, const std::string& script) {
    return WEXITSTATUS(std::system(("bash " + in_quotes(folder.write("script", script))).c_str()));
}

std::string an_earlier_result(const fs::path& out) {
    const std::string id = new_run_id();
    test::write_text(out / "run.json", R"({"program": "type21", "status": "completed", "run_id": ")" + id + "\"}");
    test::write_text(out / "nodes.csv", "time,node\n" + csv_mark(id));
    return id;
}

std::string id_of(const fs::path& out) {
    return nlohmann::json::parse(read_text(out / "run.json"))["run_id"];
}

TEST(RunEnds, ASignalEndsTheRunBetweenTwoCyclesWithWholeFiles) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        GoingOn run;
        const std::string earlier = an_earlier_result(run.deck.out());
        ASSERT_TRUE(run.writes());
        EXPECT_EQ(id_of(run.deck.out()), earlier);
        EXPECT_EQ(run.process->end(signal), 6);
        const auto json = run.run_json();
        EXPECT_EQ(json["status"], "interrupted");
        const RunFolderCheck check = check_run_id(run.deck.out());
        EXPECT_NE(check.run_id, earlier);
        EXPECT_TRUE(check.problems.empty());
        const CsvTable table = read_csv(fs::path(run.deck.out()) / "interface_1.csv");
        EXPECT_EQ(table.time.back(), json["time"].get<double>());
        EXPECT_NE(read_text(run.err()).find("interrupted"), std::string::npos) << read_text(run.err());
        EXPECT_EQ(partial_of(run.deck.out()), "");
        const std::string folder = in_quotes(run.deck.out());
        EXPECT_EQ(test::type21("compare " + folder + " " + folder).code, 2);
        EXPECT_EQ(test::type21("compare " + folder + " " + folder + " --unfinished").code, 0);
    }
}

TEST(RunEnds, AKilledRunLeavesTheEarlierResultAndTheNextOneClearsUp) {
    GoingOn run;
    const std::string earlier = an_earlier_result(run.deck.out());
    ASSERT_TRUE(run.writes());
    EXPECT_EQ(run.process->end(SIGKILL), -SIGKILL);
    EXPECT_EQ(id_of(run.deck.out()), earlier);
    EXPECT_TRUE(check_run_id(run.deck.out()).problems.empty());
    const fs::path left = partial_of(run.deck.out());
    ASSERT_NE(left, "");
    const std::string partial = in_quotes(left);
    EXPECT_EQ(test::type21("compare " + partial + " " + partial).code, 2);
    const Outcome next = test::type21("run " + in_quotes(test::cases() / "flat_press/flat_press_0000.rad") +
                                      " --quiet --out " + in_quotes(run.deck.out()));
    EXPECT_EQ(next.code, 0);
    EXPECT_NE(next.err.find("killed"), std::string::npos) << next.err;
    EXPECT_FALSE(fs::exists(left));
}

TEST(RunEnds, AKilledRunGoesOnFromItsCheckpoint) {
    const DeckCopy deck("flat_press");
    const std::string run = "run " + in_quotes(deck.starter) + " --quiet --out ";
    const std::string whole = in_quotes(deck.folder / "whole"), pieces = in_quotes(deck.folder / "pieces");
    ASSERT_EQ(test::type21(run + whole).code, 0);
    ASSERT_EQ(test::type21(run + pieces + " --checkpoint 70 --keep-checkpoints").code, 0);
    // As after kill -9: no marks, rows beyond the checkpoint, the last of them torn.
    const fs::path left = deck.folder / "pieces.01234567.partial";
    fs::rename(deck.folder / "pieces", left);
    for (const char* name : {"interface_1.csv", "nodes.csv", "rbody.csv"}) {
        const std::string text = read_text(left / name);
        test::write_text(left / name, text.substr(0, text.size() - 100));
    }
    for (const char* cycle : {"70", "140", "210", "280"}) {
        const std::string file = fmt::format("checkpoint_{:0>8}.t21", cycle);
        const Outcome outcome = test::type21(run + pieces + " --restart " + in_quotes(left / file));
        ASSERT_EQ(outcome.code, 0) << outcome.err;
        for (const char* name : {"interface_1.csv", "nodes.csv", "rbody.csv"})
            EXPECT_EQ(without_mark(deck.folder / "pieces" / name), without_mark(deck.folder / "whole" / name));
        const auto json = nlohmann::json::parse(read_text(deck.folder / "pieces/run.json"));
        EXPECT_EQ(std::to_string(json["restarted_from"]["cycle"].get<long>()), cycle);
    }
    // Any other deck, reading or implementation is refused with the reason, and nothing is written.
    const std::string restart = run + pieces + " --restart " + in_quotes(left / "checkpoint_00000140.t21");
    const std::string before = id_of(deck.folder / "pieces");
    EXPECT_NE(test::type21(restart + " --with optimized").err.find("--with was reference"), std::string::npos);
    EXPECT_NE(test::type21(restart + " --as-built D25").err.find("--as-built was none"), std::string::npos);
    test::write_text(deck.engine, read_text(deck.engine) + "# a remark\n");
    const Outcome changed = test::type21(restart);
    EXPECT_EQ(changed.code, 2);
    EXPECT_NE(changed.err.find("deck has changed"), std::string::npos) << changed.err;
    EXPECT_EQ(id_of(deck.folder / "pieces"), before);
}

TEST(RunEnds, ASignalWritesACheckpointWhereTheRunHasThem) {
    GoingOn run({"--checkpoint", "1000000000"});
    ASSERT_TRUE(run.writes());
    EXPECT_EQ(run.process->end(SIGTERM), 6);
    EXPECT_NE(read_text(run.err()).find("--restart " + run.deck.out() + "/checkpoint.t21"), std::string::npos);
    EXPECT_TRUE(fs::exists(fs::path(run.deck.out()) / "checkpoint.t21"));
}

TEST(RunEnds, AFolderThatIsRemovedIsAnErrorOfTheDisk) {
    GoingOn run;
    const std::string earlier = an_earlier_result(run.deck.out());
    ASSERT_TRUE(run.writes());
    fs::remove_all(partial_of(run.deck.out()));
    EXPECT_EQ(run.process->wait(), 5);
    const std::string err = read_text(run.err());
    EXPECT_NE(err.find("deleted"), std::string::npos) << err;
    EXPECT_EQ(err.find("internal error"), std::string::npos) << err;
    EXPECT_EQ(id_of(run.deck.out()), earlier);
}

TEST(RunEnds, AFullDiskIsAnErrorOfTheDiskAndLeavesTheEarlierResult) {
    const DeckCopy deck("flat_press");
    const std::string earlier = an_earlier_result(deck.out());
    // No file may grow beyond 40 kB: as a disk that is full for it. The signal would kill before the write fails.
    for (const char* more : {"", " --paraview", " --checkpoint 10"}) {
        const TempFolder folder;
        const int code = bash(folder, "trap '' XFSZ; ulimit -f 40; '" + std::string(TYPE21_BINARY) + "' run " +
                                          in_quotes(deck.starter) + " --quiet --out " + in_quotes(deck.out()) + more +
                                          " 2> " + in_quotes(folder / "err"));
        EXPECT_EQ(code, 5) << more << read_text(folder / "err");
        EXPECT_NE(read_text(folder / "err").find("File too large"), std::string::npos) << read_text(folder / "err");
        EXPECT_EQ(id_of(deck.out()), earlier);
        EXPECT_TRUE(check_run_id(deck.out()).problems.empty());
    }
}

TEST(RunEnds, TwoRunsIntoOneFolderNeverMix) {
    const DeckCopy first("flat_press"), second("cylinder_slide");
    const TempFolder folder;
    const std::string out = folder.path("out");
    Process one({"run", first.starter.string(), "--out", out, "--quiet"}, folder / "err1");
    Process two({"run", second.starter.string(), "--out", out, "--quiet"}, folder / "err2");
    EXPECT_EQ(one.wait(), 0) << read_text(folder / "err1");
    EXPECT_EQ(two.wait(), 0) << read_text(folder / "err2");
    const RunFolderCheck check = check_run_id(out);
    EXPECT_TRUE(check.finished());
    EXPECT_TRUE(check.problems.empty());
    EXPECT_EQ(partial_of(out), "");
}

TEST(Output, ThatIsLostIsNeverASuccess) {
    const std::string program = "'" + std::string(TYPE21_BINARY) + "' ";
    const std::string deck = in_quotes(test::cases() / "cylinder_slide/cylinder_slide_0000.rad");
    for (const std::string& arguments : {"check " + deck, std::string("departures"), std::string("--help"),
                                         std::string("--version"), std::string("laws --help")}) {
        const TempFolder folder;
        EXPECT_EQ(bash(folder, program + arguments + " > /dev/full 2> " + in_quotes(folder / "err")), 5) << arguments;
        EXPECT_NE(read_text(folder / "err").find("stdout: cannot be written: No space"), std::string::npos)
            << read_text(folder / "err");
    }
    const TempFolder folder;
    // A reader that has gone before anything is written.
    EXPECT_EQ(bash(folder, "(sleep 0.3; exec " + program + "check " + deck + ") 2> " + in_quotes(folder / "err") +
                               " | true; exit ${PIPESTATUS[0]}"),
              5);
    EXPECT_NE(read_text(folder / "err").find("Broken pipe"), std::string::npos) << read_text(folder / "err");
    EXPECT_EQ(read_text(folder / "err").find("internal"), std::string::npos);
}

TEST(Output, OfAReportTakesThePlaceOfAReportOnly) {
    const TempFolder folder;
    const auto json = [&](const fs::path& path) { return test::type21("departures --json " + in_quotes(path)); };
    EXPECT_EQ(json(folder / "new/a.json").code, 0);
    EXPECT_EQ(json(folder / "new/a.json").code, 0);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "new"), {}), 1);
    EXPECT_EQ(json("/dev/full").code, 5);
    EXPECT_EQ(json("/dev/null").code, 0);
    test::write_text(folder / "deck.rad", "#RADIOSS STARTER\n");
    EXPECT_EQ(json(folder / "deck.rad").code, 1);
    EXPECT_EQ(read_text(folder / "deck.rad"), "#RADIOSS STARTER\n");
    fs::create_symlink(folder / "deck.rad", folder / "link.json");
    EXPECT_EQ(json(folder / "link.json").code, 1);
    EXPECT_EQ(json(folder.path()).code, 1);
    EXPECT_EQ(read_text(folder / "deck.rad"), "#RADIOSS STARTER\n");
}

}  // namespace
}  // namespace type21
