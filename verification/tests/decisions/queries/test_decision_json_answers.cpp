#include <limits>

#include <gtest/gtest.h>

#include "verification/decisions/queries/decision_json.h"

namespace type21 {
namespace {

const char* const good = R"({"family": "one", "blocks": [{
  "nodes": [["0x0p+0","0x0p+0","0x0p+0"], [1,0,0], [0,1,0]], "normals": [[0,0,1],[0,0,1],[0,0,1]],
  "segments": [[0,1,2,2]], "queries": [{"p": [0.25,0.25,"0x1p-3"], "gap": 0.5, "depth": 0.5}]}]})";

std::vector<std::string> problems_of(const std::string& text) {
    std::vector<std::string> problems;
    decisions_of(nlohmann::json::parse(text), "file.json", problems);
    return problems;
}

std::string with(const std::string& what, const std::string& instead) {
    std::string text = good;
    const size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos);
    return text.replace(at, what.size(), instead);
}

TEST(DecisionJson, ReadsWhatItShould) {
    EXPECT_TRUE(problems_of(good).empty());
    std::vector<std::string> problems;
    const DecisionFile file = decisions_of(nlohmann::json::parse(good), "file.json", problems);
    ASSERT_EQ(file.blocks.size(), 1u);
    EXPECT_EQ(file.blocks[0].queries[0].point, Vec3(0.25, 0.25, 0.125));
    EXPECT_EQ(file.blocks[0].queries[0].proximity_reach, 0) << "no proximity unless asked for";
}

TEST(DecisionJson, HexFloatsLoseNoBit) {
    for (const double value : {0.1, -1.0 / 3.0, 1e-310, std::numeric_limits<double>::denorm_min(), 1.7e308, -0.0}) {
        std::vector<std::string> problems;
        const auto text = with("0.25,0.25", "\"" + to_hex(value) + "\",0.25");
        const double back = decisions_of(nlohmann::json::parse(text), "f", problems).blocks[0].queries[0].point.x();
        EXPECT_EQ(std::signbit(back), std::signbit(value));
        EXPECT_EQ(back, value) << to_hex(value);
    }
}

TEST(DecisionJson, EveryProblemIsNamedWithItsPlace) {
    const auto nan = problems_of(with("0.25,0.25", "\"nan\",\"inf\""));
    ASSERT_EQ(nan.size(), 2u);
    EXPECT_EQ(nan[0],
              "file.json: /blocks/0/queries/0/p/0: \"nan\" is not a finite number; write a hex float such as "
              "\"0x1.8p+1\"");
    const auto rank = problems_of(with("[0,1,2,2]", "[0,1,7,-1]"));
    ASSERT_EQ(rank.size(), 2u);
    EXPECT_NE(rank[0].find("/blocks/0/segments/0/2: 7 is not the index of a node: 0 to 2"), std::string::npos);
    EXPECT_NE(problems_of(with("\"gap\": 0.5", "\"gap\": -0.5")).at(0).find("negative"), std::string::npos);
    EXPECT_NE(problems_of(with("\"gap\": 0.5, ", "")).at(0).find("'gap' is missing"), std::string::npos);
    EXPECT_NE(problems_of(with(",[0,0,1]]", "]")).at(0).find("2 normals for 3 nodes"), std::string::npos);
    EXPECT_EQ(problems_of("[]").size(), 1u);
    EXPECT_EQ(problems_of("{\"blocks\": [1]}").size(), 1u);
    EXPECT_EQ(problems_of("{\"blocks\": [{}]}").size(), 4u) << "the four lists that a block needs";
}

TEST(DecisionJson, WhatIsWrittenReadsBackTheSame) {
    std::vector<std::string> problems;
    DecisionFile file = decisions_of(nlohmann::json::parse(good), "f", problems);
    file.blocks[0].answers.push_back({Kind::contact, 0, 1, +1, Stage::exact, 0.25, 3.0});
    const auto again = decisions_of(nlohmann::json::parse(to_json(file).dump()), "f", problems);
    EXPECT_TRUE(problems.empty());
    EXPECT_EQ(again.blocks[0].tool.node, file.blocks[0].tool.node);
    EXPECT_TRUE(again.blocks[0].answers[0].same_decision(file.blocks[0].answers[0]));
}

}  // namespace
}  // namespace type21
