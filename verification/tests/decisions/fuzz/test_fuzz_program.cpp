#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::in_quotes;
using test::Outcome;
using test::TempFolder;
namespace fs = std::filesystem;

std::vector<fs::path> files_in(const fs::path& folder) {
    std::vector<fs::path> files;
    if (fs::exists(folder))
        for (const auto& entry : fs::directory_iterator(folder))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

// The fuzzer is known to go red: plain double is a method that is wrong.
TEST(FuzzProgram, finds_shrinks_and_replays_a_failure) {
    TempFolder folder;
    const Outcome found = test::type21("fuzz --family mesh_on_mesh --with double --count 320 --failures " +
                                       in_quotes(folder / "failures") + " --json " + in_quotes(folder / "f.json"));
    EXPECT_EQ(found.code, 3) << found.err;
    EXPECT_NE(found.err.find("answers are wrong"), std::string::npos);
    const auto counts = nlohmann::json::parse(test::read_text(folder / "f.json"));
    EXPECT_GT(counts["families"][0]["different"].get<int>(), 0);

    const auto files = files_in(folder / "failures");
    ASSERT_FALSE(files.empty());
    const auto file = nlohmann::json::parse(test::read_text(files[0]));
    EXPECT_LE(file["blocks"][0]["segments"].size(), 2U);
    EXPECT_EQ(file["blocks"][0]["queries"].size(), 1U);
    EXPECT_EQ(file["with"], "double");

    const Outcome red = test::type21("replay " + in_quotes(files[0]));
    EXPECT_EQ(red.code, 3) << red.out << red.err;
    EXPECT_NE(red.out.find("double is WRONG: " + file["what"].get<std::string>()), std::string::npos) << red.out;
    EXPECT_EQ(test::type21("replay " + in_quotes(files[0])).out, red.out);
    // Mended: the reference is right.
    const Outcome green = test::type21("replay --with reference " + in_quotes(files[0]));
    EXPECT_EQ(green.code, 0) << green.out << green.err;
    for (const char* arithmetic : {"plain double", "double with a bound", "interval", "rational numbers", "reference",
                                   "second opinion", "margin"})
        EXPECT_NE(green.out.find(arithmetic), std::string::npos) << arithmetic;
}

TEST(FuzzProgram, writes_nothing_where_nothing_is_wrong) {
    TempFolder folder;
    const Outcome outcome = test::type21("fuzz --family one_triangle --family limits_met --count 200 --failures " +
                                         in_quotes(folder / "failures"));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_NE(outcome.out.find("limits_met"), std::string::npos);
    EXPECT_EQ(outcome.out.find("slivers"), std::string::npos);
    EXPECT_FALSE(fs::exists(folder / "failures"));
}

TEST(FuzzProgram, says_what_is_wrong_with_the_command_line) {
    const Outcome family = test::type21("fuzz --family nothing");
    EXPECT_EQ(family.code, 1);
    EXPECT_NE(family.err.find("there is no question family 'nothing'"), std::string::npos) << family.err;
    EXPECT_EQ(test::type21("fuzz --count 0").code, 1);
    EXPECT_EQ(test::type21("fuzz --list").code, 0);
    EXPECT_EQ(test::type21("replay nothing.json").code, 2);
    TempFolder folder;
    test::write_text(folder / "f.json", R"({"with": "magic", "blocks": []})");
    const Outcome method = test::type21("replay " + in_quotes(folder / "f.json"));
    EXPECT_EQ(method.code, 2);
    EXPECT_NE(method.err.find("there is no way 'magic' to decide"), std::string::npos) << method.err;
}

}  // namespace
}  // namespace type21
