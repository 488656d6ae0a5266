#include <filesystem>
#include <string>
#include <sys/stat.h>

#include <gtest/gtest.h>

#include "problem_search.h"
#include "reference/deck/deck.h"

namespace type21 {
namespace {

using test::all_of;
using test::find_rule;
using test::TempFolder;

Problems problems_of(const TempFolder& folder, std::string_view text) {
    Problems problems;
    read_deck(folder.write("bad_0000.rad", text), problems);
    return problems;
}

/// One error, and it says this.
void expect_one(const Problems& problems, std::string_view words) {
    EXPECT_EQ(problems.list().size(), 1U) << all_of(problems);
    EXPECT_TRUE(problems.has_errors());
    EXPECT_NE(find_rule(problems, words), nullptr) << all_of(problems);
}

TEST(BadFiles, MissingFile) {
    const TempFolder folder;
    Problems problems;
    const Deck deck = read_deck(folder.path("none_0000.rad"), problems);
    expect_one(problems, "no such file");
    EXPECT_TRUE(deck.starter.empty());
    EXPECT_EQ(problems.list()[0].place.file, folder.path("none_0000.rad"));
}

TEST(BadFiles, FolderAndPipe) {
    const TempFolder folder;
    std::filesystem::create_directory(folder.path("folder_0000.rad"));
    Problems problems;
    read_deck(folder.path("folder_0000.rad"), problems);
    expect_one(problems, "folder");
    ASSERT_EQ(mkfifo(folder.path("pipe_0000.rad").c_str(), 0600), 0);
    Problems more;
    read_deck(folder.path("pipe_0000.rad"), more);
    expect_one(more, "not an ordinary file");
}

TEST(BadFiles, LargerThanTwoGigabytesIsRefusedUnread) {
    const TempFolder folder;
    const std::string path = folder.write("large_0000.rad", "/BEGIN\n");
    std::error_code code;
    std::filesystem::resize_file(path, (std::uintmax_t{2} << 30) + 1, code);  // a hole, no blocks on the disk
    if (code) GTEST_SKIP() << "the disk takes no file of this size";
    Problems problems;
    read_deck(path, problems);
    expect_one(problems, "larger than 2 GB");
}

TEST(BadFiles, BinaryRubbish) {
    const TempFolder folder;
    expect_one(problems_of(folder, std::string("/BEGIN\n\0\n/END\n", 14)), "binary");
    std::string rubbish;
    for (int i = 0; i < 5000; ++i)
        rubbish.push_back(static_cast<char>(1 + (i * 73 + i / 7) % 255));
    expect_one(problems_of(folder, rubbish), "binary");
}

TEST(BadFiles, Empty) {
    const TempFolder folder;
    expect_one(problems_of(folder, ""), "holds no card");
    expect_one(problems_of(folder, "\n# nothing\n\n"), "holds no card");
}

TEST(BadFiles, NoEnd) {
    const TempFolder folder;
    const Problems problems = problems_of(folder, "/BEGIN\nrun\n/TITLE\n");
    expect_one(problems, "no /END");
    EXPECT_EQ(problems.list()[0].place.line, 3);
}

TEST(BadFiles, TextBeforeTheFirstKeywordIsOneProblem) {
    const TempFolder folder;
    const Problems problems = problems_of(folder, "\nsome\nmore\n/BEGIN\n/END\n");
    expect_one(problems, "before the first keyword");
    EXPECT_EQ(problems.list()[0].place.line, 2);
    EXPECT_EQ(problems.list()[0].count, 2);
}

TEST(BadFiles, AVeryLongLine) {
    const TempFolder folder;
    expect_one(problems_of(folder, "/TITLE\n" + std::string(2000, 'x') + "\n/END\n"), "at most 1000 characters");
    const std::string comment = "#" + std::string(2000, 'x');
    EXPECT_TRUE(problems_of(folder, comment + "\n/TITLE\n/END\n").list().empty());
}

TEST(BadFiles, MissingIncludeNamesTheLineThatAsksForIt) {
    const TempFolder folder;
    const Problems problems = problems_of(folder, "/NODE\n#include none.inc\n/END\n");
    expect_one(problems, "no such file");
    EXPECT_EQ(problems.list()[0].place.file, folder.path("bad_0000.rad"));
    EXPECT_EQ(problems.list()[0].place.line, 2);
    EXPECT_EQ(problems.list()[0].value, folder.path("none.inc"));
}

TEST(BadFiles, BinaryInclude) {
    const TempFolder folder;
    folder.write("x.inc", std::string("\0\0", 2));
    expect_one(problems_of(folder, "/NODE\n#include x.inc\n/END\n"), "binary");
}

TEST(BadFiles, EndlessInclude) {
    const TempFolder folder;
    expect_one(problems_of(folder, "/NODE\n#include bad_0000.rad\n/END\n"), "includes itself");
    folder.write("a.inc", "#include sub/../b.inc\n");
    std::filesystem::create_directory(folder.path("sub"));
    folder.write("b.inc", "#include a.inc\n");
    expect_one(problems_of(folder, "/NODE\n#include a.inc\n/END\n"), "includes itself");
}

TEST(BadFiles, IncludesNestedTooDeep) {
    const TempFolder folder;
    for (int i = 0; i < 40; ++i) {
        folder.write(std::to_string(i) + ".inc", "#include " + std::to_string(i + 1) + ".inc\n");
    }
    expect_one(problems_of(folder, "/NODE\n#include 0.inc\n/END\n"), "at most 15 deep");
}

TEST(BadFiles, IncludesThatMultiplyAtEveryLevelEnd) {
    const TempFolder folder;
    for (int i = 0; i < 14; ++i) {
        std::string ten;
        for (int j = 0; j < 10; ++j)
            ten += "#include " + std::to_string(i + 1) + ".inc\n";
        folder.write(std::to_string(i) + ".inc", ten);
    }
    folder.write("14.inc", "# leaf\n");
    expect_one(problems_of(folder, "/NODE\n#include 0.inc\n/END\n"), "inclusions");
}

}  // namespace
}  // namespace type21
