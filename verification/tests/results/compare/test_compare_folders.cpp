#include <gtest/gtest.h>

#include "verification/results/compare/compare_folders.h"
#include "verification/results/compare/comparison_text.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;
using test::write_text;

const char* const interface_text = "time,FNX,FNZ\n0,0,0\n1,1,2\n";

/// A run of ours with blank and tool nodes in one file, and a case that measured them in two.
struct Folders {
    TempFolder ours, reference;
    Folders() {
        write_text(ours / "run.json", "{}");
        write_text(ours / "interface_1.csv", interface_text);
        write_text(ours / "nodes.csv", "time,node,DX,VRX\n0,7,0,0\n0,9,0,5\n1,7,1,0\n1,9,2,5\n");
        write_text(ours / "rbody.csv", "time,rbody,X\n0,1,0\n1,1,1\n");
        write_text(reference / "interface_1.csv", interface_text);
        write_text(reference / "nodes.csv", "time,node,DX\n0,7,0\n1,7,1\n");
        write_text(reference / "tool.csv", "time,node,DX,VRX\n0,9,0,5\n1,9,2,5\n");
    }
    FolderComparison compare(const FolderOptions& options = {}) const {
        return compare_folders(ours.path(), reference.path(), options);
    }
};

TEST(CompareFolders, BlankAndToolAreInOneFileOfOurs) {
    Folders folders;
    const FolderComparison comparison = folders.compare();
    EXPECT_TRUE(comparison.ok()) << to_text(comparison);
    ASSERT_EQ(comparison.files.size(), 3U);
    EXPECT_EQ(comparison.files[2].rule.ours, "nodes.csv");
    EXPECT_EQ(comparison.files[2].table.rows, 2U);
}

TEST(CompareFolders, AMissingFileIsAMismatch) {
    Folders folders;
    std::filesystem::remove(folders.ours / "interface_1.csv");
    EXPECT_FALSE(folders.compare().ok());
    EXPECT_EQ(folders.compare().mismatches.size(), 1U);
}

TEST(CompareFolders, AnExtraFileCountsOnlyBetweenTwoRuns) {
    Folders folders;
    EXPECT_EQ(folders.compare().notes.size(), 1U);
    write_text(folders.reference / "run.json", "{}");
    EXPECT_FALSE(folders.compare().ok());
}

TEST(CompareFolders, AnUnreadableFileIsAMismatch) {
    Folders folders;
    write_text(folders.ours / "interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,,2\n");
    const FolderComparison comparison = folders.compare();
    EXPECT_FALSE(comparison.ok());
    EXPECT_NE(comparison.mismatches.at(0).find("interface_1.csv:3"), std::string::npos);
}

TEST(CompareFolders, NothingInCommonIsSaid) {
    TempFolder ours, reference;
    const FolderComparison comparison = compare_folders(ours.path(), reference.path(), {});
    EXPECT_TRUE(comparison.nothing_in_common);
    EXPECT_FALSE(comparison.ok());
    EXPECT_NE(to_text(comparison).find("Nothing in common"), std::string::npos);
}

TEST(CompareFolders, ColumnsAreTakenFromWhicheverFileHasThem) {
    Folders folders;
    write_text(folders.ours / "interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,9,2\n");
    EXPECT_FALSE(folders.compare().ok());
    EXPECT_TRUE(folders.compare({{}, {"FNZ", "VRX"}, {}}).ok());
    EXPECT_EQ(folders.compare({{}, {"FNZ", "VRX"}, {}}).files.size(), 2U);
    EXPECT_THROW(folders.compare({{}, {"FNZ", "NOPE"}, {}}), WrongOption);
}

TEST(CompareFolders, RulesOfTheCaseAreUsedAndAToleranceOverridesThem) {
    Folders folders;
    write_text(folders.ours / "interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,1.5,2\n");
    FolderOptions options;
    FileRule rule{"interface_1.csv", "interface_1.csv", {}, "criterion 'wide'", "because"};
    rule.options.tolerance = 0.5;
    options.rules.push_back(rule);
    EXPECT_TRUE(folders.compare(options).ok());
    EXPECT_NE(to_text(folders.compare(options)).find("criterion 'wide': because"), std::string::npos);
    options.tolerance = 0.4;
    EXPECT_FALSE(folders.compare(options).ok());
}

TEST(CompareFolders, JsonHasNoNumberThatJsonLacks) {
    Folders folders;
    write_text(folders.ours / "interface_1.csv", "time,FNX,FNZ\n0,0,0\n1,nan,2\n");
    const nlohmann::ordered_json json = to_json(folders.compare());
    EXPECT_EQ(json["verdict"], "differ");
    EXPECT_EQ(json["files"][0]["columns"][0]["difference"], "inf");
    EXPECT_EQ(json["files"][0]["columns"][0]["ours"], "nan");
    EXPECT_EQ(json["files"][0]["columns"][1]["verdict"], "ok");
}

}  // namespace
}  // namespace type21
