#include <set>

#include <gtest/gtest.h>

#include "verification/results/record/result_folder.h"
#include "verification/results/record/run_id.h"
#include "verification/support/io_error.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::read_text;
using test::TempFolder;
using test::write_text;
namespace fs = std::filesystem;

/// Writes a result of one file, marked with `text`, and takes the place.
void run_into(const fs::path& target, const std::string& text) {
    const std::string id = new_run_id();
    ResultFolder folder(target, id);
    write_text(folder.path() / "run.json", R"({"program": "type21", "status": "completed", "run_id": ")" + id + "\"}");
    write_text(folder.path() / "nodes.csv", text + "\n" + csv_mark(id));
    folder.publish(false);
}

std::string message_of(const fs::path& target) {
    try {
        const ResultFolder folder(target, new_run_id());
        return "";
    } catch (const FolderError& error) {
        return error.what();
    }
}

std::set<std::string> names_in(const fs::path& folder) {
    std::set<std::string> names;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

TEST(ResultFolder, AppearsAtTheEndWithItsParents) {
    TempFolder folder;
    {
        const ResultFolder result(folder / "a/b/", new_run_id());
        EXPECT_FALSE(fs::exists(folder / "a/b"));
        EXPECT_TRUE(fs::is_directory(result.path()));
    }
    EXPECT_TRUE(names_in(folder / "a").empty());  // it was not published
    run_into(folder / "a/b/", "one");
    EXPECT_EQ(names_in(folder / "a"), std::set<std::string>{"b"});
    EXPECT_EQ(names_in(folder / "a/b"), (std::set<std::string>{"nodes.csv", "run.json"}));
}

TEST(ResultFolder, TheEarlierResultStaysUntilTheEnd) {
    TempFolder folder;
    run_into(folder / "out", "one");
    {
        const ResultFolder result(folder / "out", new_run_id());
        write_text(result.path() / "nodes.csv", "two");
        EXPECT_TRUE(read_text(folder / "out/nodes.csv").starts_with("one"));
    }
    EXPECT_TRUE(read_text(folder / "out/nodes.csv").starts_with("one"));
    run_into(folder / "out", "two");
    EXPECT_TRUE(read_text(folder / "out/nodes.csv").starts_with("two"));
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"out"});
}

TEST(ResultFolder, TwoAtATimeAreBothWholeAndTheLaterStays) {
    TempFolder folder;
    const auto write = [](const ResultFolder& result, const std::string& text) {
        write_text(result.path() / "run.json", R"({"program": "type21"})");
        write_text(result.path() / "nodes.csv", text);
    };
    ResultFolder first(folder / "out", new_run_id());
    write(first, "first");
    ResultFolder second(folder / "out", new_run_id());
    ASSERT_EQ(second.notes().size(), 1U);
    EXPECT_NE(second.notes()[0].find("another run"), std::string::npos) << second.notes()[0];
    write(second, "second");
    second.publish(false);
    EXPECT_EQ(read_text(folder / "out/nodes.csv"), "second");
    first.publish(true);
    EXPECT_EQ(read_text(folder / "out/nodes.csv"), "first");
    EXPECT_EQ(names_in(folder.path()), std::set<std::string>{"out"});
}

TEST(ResultFolder, WhatARunDidNotWriteIsRefusedAndKept) {
    TempFolder folder;
    for (const char* name : {"notes.txt", "tool.csv", "interface_7.csv", "paraview/state.pvsm", "run.json.bak"}) {
        const fs::path out = folder / ("of_" + fs::path(name).stem().string());
        run_into(out, "one");
        write_text(out / name, "mine");
        const std::string message = message_of(out);
        EXPECT_NE(message.find(name), std::string::npos) << message;
        EXPECT_EQ(read_text(out / name), "mine");
        EXPECT_TRUE(fs::exists(out / "nodes.csv"));
    }
    write_text(folder / "measured/interface_1.csv", "measured");
    EXPECT_NE(message_of(folder / "measured").find("run.json"), std::string::npos);
    write_text(folder / "other/run.json", R"({"program": "another"})");
    EXPECT_NE(message_of(folder / "other"), "");
}

TEST(ResultFolder, AnythingButAFolderIsRefused) {
    TempFolder folder;
    write_text(folder / "out", "x");
    EXPECT_NE(message_of(folder / "out").find("is a file"), std::string::npos);
    EXPECT_NE(message_of(folder / "out/below"), "");
    run_into(folder / "result", "one");
    fs::create_directory_symlink(folder / "result", folder / "link");
    fs::create_symlink(folder / "nothing", folder / "dangling");
    EXPECT_NE(message_of(folder / "link").find("is a link"), std::string::npos);
    EXPECT_NE(message_of(folder / "link/").find("is a link"), std::string::npos);
    EXPECT_NE(message_of(folder / "dangling").find("is a link"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "nothing"));
    EXPECT_NE(message_of("/proc"), "");
    // A link in the place of a file of the result.
    fs::remove(folder / "result/nodes.csv");
    fs::create_symlink(folder / "out", folder / "result/nodes.csv");
    EXPECT_NE(message_of(folder / "result").find("nodes.csv"), std::string::npos);
    EXPECT_EQ(read_text(folder / "out"), "x");
}

TEST(ResultFolder, WhatAKilledRunLeftIsRemovedOrNamed) {
    TempFolder folder;
    write_text(folder / "out.01234567.partial/run.json", R"({"program": "type21", "status": "running"})");
    write_text(folder / "out.01234567.partial/nodes.csv", "time,no");
    write_text(folder / "out.89abcdef.partial/run.json", R"({"program": "type21", "status": "running"})");
    write_text(folder / "out.89abcdef.partial/checkpoint.t21", "x");
    write_text(folder / "out.00000000.partial/mine", "x");
    const ResultFolder result(folder / "out", new_run_id());
    ASSERT_EQ(result.notes().size(), 2U);
    EXPECT_NE(result.notes()[0].find("removed"), std::string::npos) << result.notes()[0];
    EXPECT_NE(result.notes()[1].find("--restart"), std::string::npos) << result.notes()[1];
    EXPECT_FALSE(fs::exists(folder / "out.01234567.partial"));
    EXPECT_TRUE(fs::exists(folder / "out.89abcdef.partial/checkpoint.t21"));
    EXPECT_TRUE(fs::exists(folder / "out.00000000.partial/mine"));
}

TEST(ResultFolder, APlaceThatIsTakenMeanwhileLosesNothing) {
    TempFolder folder;
    fs::path path;
    {
        ResultFolder result(folder / "out", new_run_id());
        path = result.path();
        write_text(path / "run.json", R"({"program": "type21"})");
        write_text(folder / "out/mine.txt", "mine");
        EXPECT_THROW(result.publish(false), IoError);
    }
    EXPECT_EQ(read_text(folder / "out/mine.txt"), "mine");
    EXPECT_TRUE(fs::exists(path / "run.json"));
}

TEST(RunId, IsAnotherEachTimeAndHasTheFormOfAUuid) {
    std::set<std::string> ids;
    for (int i = 0; i < 100; ++i)
        ids.insert(new_run_id());
    EXPECT_EQ(ids.size(), 100U);
    for (const std::string& id : ids) {
        ASSERT_EQ(id.size(), 36U);
        EXPECT_EQ(id[14], '4');
        for (const size_t at : {8U, 13U, 18U, 23U})
            EXPECT_EQ(id[at], '-') << id;
    }
}

TEST(RunId, OfAllFilesIsChecked) {
    TempFolder folder;
    EXPECT_FALSE(check_run_id(folder.path()).is_run);
    run_into(folder / "out", "one");
    EXPECT_TRUE(check_run_id(folder / "out").problems.empty());
    EXPECT_TRUE(check_run_id(folder / "out").finished());
    write_text(folder / "out/interface_1.csv", "time\n" + csv_mark(new_run_id()));
    write_text(folder / "out/rbody.csv", "time\n0\n");
    write_text(folder / "out/paraview/tool_1.pvd", "<?xml?>\n" + xml_mark("other") + "<x/>");
    const RunFolderCheck check = check_run_id(folder / "out");
    ASSERT_EQ(check.problems.size(), 3U);
    EXPECT_NE(check.problems[0].find("interface_1.csv: of run"), std::string::npos) << check.problems[0];
    EXPECT_NE(check.problems[1].find("of run other"), std::string::npos) << check.problems[1];
    EXPECT_NE(check.problems[2].find("rbody.csv: no run id"), std::string::npos) << check.problems[2];
}

}  // namespace
}  // namespace type21
