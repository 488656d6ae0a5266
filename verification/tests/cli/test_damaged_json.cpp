/// @file JSON from outside: exit code 2, the place of what is wrong, and a short message.
#include <gtest/gtest.h>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::in_quotes;
using test::Outcome;

const char* const decisions =
    R"({"blocks": [{"nodes": [[1, 0, 0], [0, 1, 0], [0, 0, 0]], "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]],
        "segments": [[0, 1, 2, 2]], "queries": [{"p": [0.25, 0.25, 0.125], "gap": 0.25, "depth": 0.25}]}]})";

std::string decisions_with(const std::string& what, const std::string& instead) {
    std::string text = decisions;
    return text.replace(text.find(what), what.size(), instead);
}

/// Of decide and of replay: both read the file in the same way.
void expect_refused(const std::string& text, const std::string& part) {
    test::TempFolder folder;
    folder.write("x.json", text);
    for (const char* command : {"decide ", "replay "}) {
        const Outcome outcome = test::type21(command + in_quotes(folder / "x.json"));
        EXPECT_EQ(outcome.code, 2) << command << outcome.err;
        EXPECT_EQ(outcome.out, "") << command;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << command << outcome.err;
        EXPECT_LT(outcome.err.size(), 1000U) << command;
    }
}

TEST(DamagedJson, IsRefusedWithItsPlace) {
    expect_refused(decisions_with("[1, 0, 0]", "[1e400, 0, 0]"),
                   "/blocks/0/nodes/0/0: '1e400' is too large for a double");
    expect_refused(decisions_with("[1, 0, 0]", std::string(1000000, '[') + std::string(1000000, ']')),
                   "/blocks/0/nodes/0/0/0");
    expect_refused(decisions_with("0.25, 0.25, 0.125", "NaN, 0, 0"), "/blocks/0/queries/0/p/0: is not JSON");
    expect_refused(decisions_with("\"depth\"", "\"gap\": 1, \"depth\""),
                   "/blocks/0/queries/0/gap: the key is there twice");
    expect_refused(decisions_with("\"depth\"", "\"dept\""), "did you mean 'depth'?");
    expect_refused(decisions_with("[1, 0, 0]", "{\"x\": 1}"), "/blocks/0/nodes/0: an object with 1 key stands where");
    expect_refused(decisions_with("[0, 1, 2, 2]", "[0, 1, 2, 1e18]"), "/blocks/0/segments/0/3");
    expect_refused(std::string(decisions) + "}", "is not JSON");
    expect_refused("", "is not JSON");
}

TEST(DamagedJson, AnEntryOfTheAtlasWithWrongTypesIsRefused) {
    const std::string entry = test::read_text(test::cases() / "atlas/fan.json");
    const auto refused = [&](const std::string& what, const std::string& instead, const std::string& part) {
        test::TempFolder folder;
        std::string text = entry;
        const size_t at = text.find(what);
        ASSERT_NE(at, std::string::npos) << what;
        folder.write("x.json", text.replace(at, what.size(), instead));
        const Outcome outcome = test::type21("atlas x --folder " + in_quotes(folder.path()));
        EXPECT_EQ(outcome.code, 2) << outcome.err;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << outcome.err;
    };
    refused("\"title\": \"", "\"title\": 7, \"name\": \"", "/title: 7 stands where a text is wanted");
    refused("\"note\": [", "\"note\": [[], ", "/blocks/0/note/0: a list of 0 values stands where a text is wanted");
    refused("\"note\"", "\"not\"", "did you mean 'note'?");
    refused("\"double\": [", "\"double\": 1, \"program\": [", "/blocks/0/double: 1 stands where a list is wanted");
}

/// The area test is exact: what takes a node is not called flat.
TEST(DamagedJson, ATinySegmentIsNotCalledFlat) {
    test::TempFolder folder;
    const auto decide = [&](const char* edge, const char* corner) {
        folder.write("x.json", fmt::format(R"({{"blocks":[{{"nodes":[["{0}",0,0],[0,"{0}",0],[{1},0,0]],
            "normals":[[0,0,1],[0,0,1],[0,0,1]],"segments":[[0,1,2,2]],
            "queries":[{{"p":[0,0,"{0}"],"gap":1,"depth":1}}]}}]}})",
                                           edge, corner));
        return test::type21("decide " + in_quotes(folder / "x.json"));
    };
    for (const char* edge : {"0x1p-560", "0x1p-1074", "0x1p-500", "0x1p+600", "0x1p+0"}) {
        const Outcome outcome = decide(edge, "0");
        EXPECT_EQ(outcome.code, 0) << edge << outcome.err;
        EXPECT_EQ(outcome.err.find("no area"), std::string::npos) << edge << outcome.err;
    }
    folder.write("flat.json", R"({"blocks":[{"nodes":[["0x1p-560",0,0],["0x1p-559",0,0],[0,0,0]],
        "normals":[[0,0,1],[0,0,1],[0,0,1]],"segments":[[0,1,2,2]],"queries":[{"p":[0,0,0.5],"gap":1,"depth":1}]}]})");
    const Outcome flat = test::type21("decide " + in_quotes(folder / "flat.json"));
    EXPECT_NE(flat.err.find("1 segments have no area"), std::string::npos) << flat.err;
    EXPECT_NE(flat.out.find("\"kind\": \"none\""), std::string::npos) << flat.out;
}

}  // namespace
}  // namespace type21
