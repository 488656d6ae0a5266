#include <filesystem>
#include <fstream>
#include <string>
#include <sys/stat.h>
#include <vector>

#include <gtest/gtest.h>

#include "problem_search.h"
#include "reference/deck/deck.h"
#include "reference/deck/include_line.h"

namespace type21 {
namespace {

using test::all_of;
using test::find_rule;
using test::keywords_of;
using test::TempFolder;

Deck read_scene(const TempFolder& folder, std::string_view text, Problems& problems) {
    return read_deck(folder.write("scene_0000.rad", text), problems);
}

using Names = std::vector<std::string>;

TEST(Includes, EndOfAnIncludeEndsThatFileAlone) {
    const TempFolder folder;
    folder.write("mesh.inc", "/NODE\n/END\n/PART/9\n");
    folder.write("outer.inc", "#include mesh.inc\n/PART/2\n/END\n/PART/8\n");
    Problems problems;
    const Deck deck =
        read_scene(folder, "/BEGIN\n#include mesh.inc\n/PART/1\n#include outer.inc\n/PART/3\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(keywords_of(deck.starter), (Names{"/BEGIN", "/NODE", "/PART/1", "/NODE", "/PART/2", "/PART/3"}));
}

TEST(Includes, BeginOfAnIncludeIsNotRead) {
    const TempFolder folder;
    folder.write("mesh.inc", "#RADIOSS STARTER\n/BEGIN\nmesh\n      2025\n  Mg\n  Mg\n/NODE\n         1\n/END\n");
    Problems problems;
    const Deck deck = read_scene(folder, "/BEGIN\nmain\n#include mesh.inc\n/PART/1\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(keywords_of(deck.starter), (Names{"/BEGIN", "/NODE", "/PART/1"}));
    EXPECT_EQ(deck.starter[0].lines.size(), 1U) << "the lines of the other /BEGIN go nowhere";
    EXPECT_EQ(deck.starter[1].lines.size(), 1U);
    ASSERT_EQ(deck.unread.size(), 1U);
    EXPECT_EQ(deck.unread[0].lines.size(), 4U);
}

TEST(Includes, BeginWithinASubmodelIsRead) {
    const TempFolder folder;
    folder.write("dummy.inc", "/BEGIN\ndummy\n/NODE\n");
    Problems problems;
    const Deck deck = read_scene(
        folder, "/BEGIN\n//SUBMODEL/1\nt\n#include dummy.inc\n//ENDSUB\n#include dummy.inc\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(keywords_of(deck.starter), (Names{"/BEGIN", "/NODE", "/NODE"}));
    EXPECT_EQ(deck.unread.size(), 1U);
}

TEST(Includes, EnddataEndsTheFileItStandsIn) {
    const TempFolder folder;
    folder.write("contact.inc", "/INTER/TYPE21/1\nfirst\n#enddata\n/INTER/TYPE21/2\nparked\n");
    folder.write("upper.inc", "/PART/1\n#ENDDATA  old parts\n/PART/2\n");
    folder.write("comment.inc", "/PART/3\n#enddatabase\n/PART/4\n");
    Problems problems;
    const Deck deck =
        read_scene(folder,
                   "/BEGIN\n#include contact.inc\n#include upper.inc\n#include comment.inc\n/PART/5\n#enddata\n"
                   "/PART/6\n/END\n",
                   problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(keywords_of(deck.starter),
              (Names{"/BEGIN", "/INTER/TYPE21/1", "/PART/1", "/PART/3", "/PART/4", "/PART/5"}));
}

TEST(Includes, AreLookedForBesideTheIncludingFileThenBesideTheMainDeck) {
    const TempFolder folder;
    folder.write("sets/outer.inc", "#include inner.inc\n#include common.inc\n");
    folder.write("sets/inner.inc", "/PART/1\n");
    folder.write("common.inc", "/PART/2\n");
    Problems problems;
    const Deck deck = read_scene(folder, "/BEGIN\n#include sets/outer.inc\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(keywords_of(deck.starter), (Names{"/BEGIN", "/PART/1", "/PART/2"}));
}

TEST(Includes, AreLookedForInTheWorkingDirectoryLast) {
    EXPECT_EQ(include_paths("x.inc", "a/b/c.inc", "a/m_0000.rad"), (Names{"a/b/x.inc", "a/x.inc", "x.inc"}));
    EXPECT_EQ(include_paths("s\\x.inc", "m_0000.rad", "m_0000.rad"), (Names{"s\\x.inc", "s/x.inc"}));
    EXPECT_EQ(include_paths("/data/x.inc", "a/b/c.inc", "a/m_0000.rad"), (Names{"/data/x.inc"}));
}

TEST(Includes, TwoFilesOfOneNameAreAWarning) {
    const TempFolder folder;
    folder.write("sets/outer.inc", "#include common.inc\n");
    folder.write("sets/common.inc", "/PART/1\n");
    folder.write("common.inc", "/PART/2\n");
    Problems problems;
    const Deck deck = read_scene(folder, "/BEGIN\n#include sets/outer.inc\n/END\n", problems);
    EXPECT_EQ(keywords_of(deck.starter), (Names{"/BEGIN", "/PART/1"}));
    const Problem* warning = find_rule(problems, "two files have this name");
    ASSERT_NE(warning, nullptr) << all_of(problems);
    EXPECT_EQ(warning->severity, Severity::warning);
}

TEST(Includes, QuotesBackslashesCaseAndCommentsBehindTheName) {
    using List = std::optional<Names>;
    EXPECT_EQ(included_names("#include a b.inc"), List({"a b.inc"}));
    EXPECT_EQ(included_names("#Include \"a b.inc\"   # the mesh"), List({"a b.inc"}));
    EXPECT_EQ(included_names("#INCLUDE 'a.inc'"), List({"a.inc"}));
    EXPECT_EQ(included_names("#include\"a.inc\""), List({"a.inc"}));
    EXPECT_EQ(included_names("#include a.inc # the mesh"), List({"a.inc # the mesh", "a.inc"}));
    EXPECT_EQ(included_names("#include a.inc $ mesh"), List({"a.inc $ mesh", "a.inc"}));
    EXPECT_EQ(included_names("#include"), List({""}));
    EXPECT_EQ(included_names("#include \"\""), List({""}));
    EXPECT_EQ(included_names("#included files follow"), std::nullopt);
    EXPECT_EQ(included_names("# include a.inc"), std::nullopt);
    const TempFolder folder;
    folder.write("sub/a.inc", "/PART/1\n");
    Problems problems;
    const Deck deck = read_scene(folder, "#INCLUDE sub\\a.inc   # the mesh\n#include sub/a.inc $\n/END\n", problems);
    EXPECT_TRUE(problems.list().empty()) << all_of(problems);
    EXPECT_EQ(deck.starter.size(), 2U);
}

TEST(Includes, WithoutANameOrOfASpecialFileAreErrors) {
    for (const char* line : {"#include", "#include \"\"", "#include ''", "#include .", "#include /proc/self/mem",
                             "#include /proc/self/status", "#include /sys/kernel/profiling", "#include /dev/null",
                             "#include /dev/zero", "#include \"\\x\""}) {
        const TempFolder folder;
        Problems problems;
        read_scene(folder, std::string("/BEGIN\n") + line + "\n/END\n", problems);
        ASSERT_EQ(problems.error_count(), 1) << line << '\n' << all_of(problems);
        EXPECT_EQ(problems.list()[0].card, "#include") << line;
        EXPECT_EQ(problems.list()[0].place.line, 2) << line;
    }
}

TEST(Includes, OfAPipeNeverWaits) {
    const TempFolder folder;
    ASSERT_EQ(mkfifo(folder.path("pipe").c_str(), 0600), 0);
    Problems problems;
    read_scene(folder, "/BEGIN\n#include pipe\n/END\n", problems);
    EXPECT_NE(find_rule(problems, "not an ordinary file"), nullptr) << all_of(problems);
}

TEST(Includes, AnEmptyFileIsAWarning) {
    const TempFolder folder;
    folder.write("empty.inc", "");
    Problems problems;
    read_scene(folder, "/BEGIN\n#include empty.inc\n/END\n", problems);
    ASSERT_EQ(problems.list().size(), 1U) << all_of(problems);
    EXPECT_EQ(problems.list()[0].severity, Severity::warning);
    EXPECT_EQ(problems.list()[0].rule, "the file is empty");
}

TEST(Includes, ANameThatDiffersInCaseIsNamed) {
    const TempFolder folder;
    folder.write("Mesh.inc", "/PART/1\n");
    if (std::filesystem::exists(folder.path("MESH.INC"))) GTEST_SKIP() << "this disk knows no case";
    Problems problems;
    read_scene(folder, "/BEGIN\n#include MESH.INC\n/END\n", problems);
    ASSERT_EQ(problems.error_count(), 1) << all_of(problems);
    EXPECT_NE(problems.list()[0].remedy.find("'Mesh.inc'"), std::string::npos) << all_of(problems);
}

TEST(Includes, AVeryLongNameIsAnErrorOfBoundedLength) {
    const TempFolder folder;
    Problems problems;
    read_scene(folder, "/BEGIN\n#include " + std::string(90000, 'x') + "\n/END\n", problems);
    ASSERT_EQ(problems.error_count(), 1);
    EXPECT_LT(to_text(problems.list()[0]).size(), 1000U);
}

}  // namespace
}  // namespace type21
