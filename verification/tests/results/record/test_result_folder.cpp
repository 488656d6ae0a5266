#include <gtest/gtest.h>

#include "verification/results/record/result_folder.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::read_text;
using test::TempFolder;
using test::write_text;
namespace fs = std::filesystem;

TEST(ResultFolder, IsMadeWithItsParents) {
    TempFolder folder;
    prepare_folder(folder / "a/b");
    EXPECT_TRUE(fs::is_directory(folder / "a/b"));
}

TEST(ResultFolder, LosesAnEarlierResultAndNothingElse) {
    TempFolder folder;
    for (const char* name :
         {"run.json", "interface_1.csv", "interface_22.csv", "nodes.csv", "rbody.csv", "notes.txt", "tool.csv"})
        write_text(folder / name, "x");
    prepare_folder(folder.path());
    for (const char* name : {"run.json", "interface_1.csv", "interface_22.csv", "nodes.csv", "rbody.csv"})
        EXPECT_FALSE(fs::exists(folder / name)) << name;
    EXPECT_TRUE(fs::exists(folder / "notes.txt"));
    EXPECT_TRUE(fs::exists(folder / "tool.csv"));
}

TEST(ResultFolder, RefusesHistoriesThatNoRunWrote) {
    TempFolder folder;
    write_text(folder / "interface_1.csv", "measured");
    EXPECT_THROW(prepare_folder(folder.path()), FolderError);
    EXPECT_EQ(read_text(folder / "interface_1.csv"), "measured");
}

TEST(ResultFolder, RefusesAFile) {
    TempFolder folder;
    write_text(folder / "out", "x");
    EXPECT_THROW(prepare_folder(folder / "out"), FolderError);
    EXPECT_THROW(prepare_folder(folder / "out/below"), FolderError);
}

}  // namespace
}  // namespace type21
