#include <gtest/gtest.h>

#include "verification/results/record/checkpoint.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::read_text;
using test::TempFolder;
using test::write_text;

Checkpoint example(const TempFolder& folder) {
    CsvWriter csv(folder / "nodes.csv", {"time", "node", "DX"});
    csv.row("0.5", 7, {0.25});
    csv.flush();
    Checkpoint checkpoint{"an-id",
                          40,
                          0.1,
                          {"program", "inputs", "none", "reference", true},
                          {csv.written()},
                          {0, 0.1},
                          std::string("\0\1\n{}", 5)};
    csv.row("0.75", 7, {0.5});
    csv.close("# the end\n");
    return checkpoint;
}

template <class Act>
std::string failure_of(const Act& act) {
    try {
        act();
        return "";
    } catch (const CheckpointError& error) {
        return error.what();
    }
}

TEST(Checkpoint, IsReadAsItWasWritten) {
    TempFolder folder;
    const Checkpoint written = example(folder);
    write_checkpoint(folder / "c.t21", written);
    const Checkpoint read = read_checkpoint(folder / "c.t21");
    EXPECT_EQ(read.run_id, written.run_id);
    EXPECT_EQ(read.cycle, 40);
    EXPECT_EQ(read.time, 0.1);
    EXPECT_EQ(read.state, written.state);
    EXPECT_EQ(read.paraview_times, written.paraview_times);
    ASSERT_EQ(read.files.size(), 1U);
    EXPECT_EQ(read.files[0].bytes, written.files[0].bytes);
    EXPECT_NO_THROW(require_same(folder / "c.t21", read.identity, written.identity));
}

TEST(Checkpoint, EveryDamageIsFound) {
    TempFolder folder;
    write_checkpoint(folder / "c.t21", example(folder));
    const std::string whole = read_text(folder / "c.t21");
    for (size_t size = 0; size < whole.size(); ++size) {
        write_text(folder / "cut.t21", std::string_view(whole).substr(0, size));
        EXPECT_NE(failure_of([&] { read_checkpoint(folder / "cut.t21"); }), "") << size;
    }
    for (size_t at = 0; at < whole.size(); ++at) {
        std::string spoilt = whole;
        spoilt[at] = static_cast<char>(spoilt[at] ^ 4);
        write_text(folder / "spoilt.t21", spoilt);
        EXPECT_NE(failure_of([&] { read_checkpoint(folder / "spoilt.t21"); }), "") << at;
    }
    write_text(folder / "more.t21", whole + "x");
    EXPECT_NE(failure_of([&] { read_checkpoint(folder / "more.t21"); }).find("damaged"), std::string::npos);
    write_text(folder / "deck.t21", "#RADIOSS STARTER\n");
    EXPECT_NE(failure_of([&] { read_checkpoint(folder / "deck.t21"); }).find("is not a checkpoint"), std::string::npos);
    EXPECT_NE(failure_of([&] { read_checkpoint(folder / "none.t21"); }), "");
    EXPECT_NE(failure_of([&] { read_checkpoint(folder.path()); }), "");
}

TEST(Checkpoint, EveryDifferenceIsNamedAtOnce) {
    const RunIdentity then{"1", "2", "none", "reference", false};
    const RunIdentity now{"5", "6", "D24", "optimized", true};
    const std::string message = failure_of([&] { require_same("c.t21", then, now); });
    for (const char* part : {"deck has changed", "--as-built was none, and is D24", "--with was reference",
                             "--paraview was not given", "the program was 1, and is 5"})
        EXPECT_NE(message.find(part), std::string::npos) << part << message;
}

TEST(Checkpoint, TheInputsAreTheirBytes) {
    TempFolder folder;
    const std::string deck = folder.write("deck", "/BEGIN"), other = folder.write("other", "/END");
    const auto inputs = [&] { return identity_of({deck, other}, "none", "reference", false).inputs; };
    const std::string before = inputs();
    EXPECT_EQ(inputs(), before);
    write_text(deck, "/BEGIN/END");
    write_text(other, "");
    EXPECT_NE(inputs(), before);
}

TEST(Checkpoint, HistoriesAreCopiedAsTheyWereAndChecked) {
    TempFolder folder, into, again;
    const Checkpoint checkpoint = example(folder);
    copy_histories(folder / "c.t21", checkpoint, into.path());
    EXPECT_EQ(read_text(into / "nodes.csv"), "time,node,DX\n0.5,7,0.25\n");
    {
        CsvWriter csv(into / "nodes.csv", {"time", "node", "DX"});
        csv.row("0.75", 7, {0.5});
        csv.close("# the end\n");
    }
    EXPECT_EQ(read_text(into / "nodes.csv"), read_text(folder / "nodes.csv"));

    const std::string whole = read_text(folder / "nodes.csv");
    write_text(folder / "nodes.csv", whole.substr(0, 15));
    EXPECT_NE(failure_of([&] { copy_histories(folder / "c.t21", checkpoint, again.path()); }).find("cut off"),
              std::string::npos);
    TempFolder third;
    std::string changed = whole;
    changed[15] = '9';
    write_text(folder / "nodes.csv", changed);
    EXPECT_NE(failure_of([&] { copy_histories(folder / "c.t21", checkpoint, third.path()); }).find("changed"),
              std::string::npos);
    TempFolder fourth;
    std::filesystem::remove(folder / "nodes.csv");
    EXPECT_NE(failure_of([&] { copy_histories(folder / "c.t21", checkpoint, fourth.path()); }), "");
}

}  // namespace
}  // namespace type21
