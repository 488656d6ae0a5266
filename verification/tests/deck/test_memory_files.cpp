#include <gtest/gtest.h>

#include "problem_search.h"
#include "reference/deck/deck.h"

namespace type21 {
namespace {

using test::all_of;
using test::find_rule;
using test::TempFolder;

constexpr const char* starter = "/BEGIN\nrun\n#include parts/nodes.inc\n/TITLE\n/END\n";
constexpr const char* nodes = "/NODE\n         1\n";
constexpr const char* engine = "/RUN/x/1\n1.0\n";

std::vector<MemoryFile> in_memory() {
    return {{"x_0000.rad", starter}, {"parts/nodes.inc", nodes}, {"x_0001.rad", engine}};
}

TEST(MemoryFiles, GiveTheCardsThatTheSameFilesOnTheDiskGive) {
    const TempFolder folder;
    folder.write("parts/nodes.inc", nodes);
    folder.write("x_0001.rad", engine);
    Problems from_disk;
    const Deck disk = read_deck(folder.write("x_0000.rad", starter), from_disk);
    Problems from_memory;
    const Deck memory = read_deck(in_memory(), from_memory);
    EXPECT_TRUE(from_disk.list().empty()) << all_of(from_disk);
    EXPECT_TRUE(from_memory.list().empty()) << all_of(from_memory);
    ASSERT_EQ(memory.starter.size(), 3U);
    ASSERT_EQ(memory.starter.size(), disk.starter.size());
    for (size_t i = 0; i < memory.starter.size(); ++i) {
        EXPECT_EQ(memory.starter[i].keyword, disk.starter[i].keyword);
        EXPECT_EQ(memory.starter[i].lines.size(), disk.starter[i].lines.size());
        EXPECT_EQ(memory.place(memory.starter[i]).line, disk.place(disk.starter[i]).line);
    }
    EXPECT_TRUE(memory.has_engine);
    EXPECT_EQ(memory.engine.size(), disk.engine.size());
}

TEST(MemoryFiles, NeverReadTheDisk) {
    const TempFolder folder;
    const std::string outside = folder.write("outside.inc", nodes);
    Problems problems;
    read_deck({MemoryFile{"x_0000.rad", "/BEGIN\n#include " + outside + "\n/END\n"}}, problems);
    EXPECT_NE(find_rule(problems, "no such file"), nullptr) << all_of(problems);
}

TEST(MemoryFiles, AFileThatIncludesItselfIsFoundByAnyOfItsNames) {
    Problems problems;
    read_deck({{"x_0000.rad", "/BEGIN\n#include a.inc\n/END\n"}, {"a.inc", "#include sub/.././a.inc\n"}}, problems);
    EXPECT_NE(find_rule(problems, "includes itself"), nullptr) << all_of(problems);
}

TEST(MemoryFiles, NoFilesAreNoDeck) {
    Problems problems;
    EXPECT_TRUE(read_deck(std::vector<MemoryFile>{}, problems).starter.empty());
}

}  // namespace
}  // namespace type21
