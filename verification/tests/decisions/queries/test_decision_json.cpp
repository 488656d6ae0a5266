#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "verification/decisions/queries/decision_json.h"

namespace type21 {
namespace {

using Json = nlohmann::json;

/// One triangle, one query.
Json good() {
    return Json::parse(R"({"blocks": [{"nodes": [[1, 0, 0], [0, 1, 0], [0, 0, 0]],
        "normals": [[0, 0, 1], [0, 0, 1], [0, 0, 1]], "segments": [[0, 1, 2, 2]],
        "queries": [{"p": [0.25, 0.25, 0.125], "gap": 0.25, "depth": 0.25, "reach": 0}]}]})");
}

std::vector<std::string> problems_of(const Json& json) {
    std::vector<std::string> problems;
    decisions_of(json, "f", problems);
    return problems;
}

TEST(DecisionJson, writes_a_double_so_that_the_same_bits_are_read) {
    using Limits = std::numeric_limits<double>;
    for (const double value : {0.0, -0.0, 1.0, -0.1, 1e150, -1e-150, Limits::denorm_min(), -7 * Limits::denorm_min(),
                               Limits::min(), Limits::max(), std::nextafter(1.0, 2.0)}) {
        Json json = good();
        json["blocks"][0]["queries"][0]["p"][0] = to_hex(value);
        std::vector<std::string> problems;
        const DecisionFile file = decisions_of(json, "f", problems);
        ASSERT_TRUE(problems.empty()) << problems[0];
        const double read = file.blocks[0].queries[0].point.x();
        EXPECT_EQ(read, value);
        EXPECT_EQ(std::signbit(read), std::signbit(value));
    }
    EXPECT_EQ(to_hex(1.5), "0x1.8p+0");
    EXPECT_EQ(to_hex(-0.0), "-0x0p+0");
}

TEST(DecisionJson, reads_what_it_writes) {
    std::vector<std::string> problems;
    const DecisionFile file = decisions_of(good(), "f", problems);
    const DecisionFile again = decisions_of(Json::parse(to_json(file).dump()), "g", problems);
    ASSERT_TRUE(problems.empty()) << problems[0];
    EXPECT_EQ(to_json(again), to_json(file));
    EXPECT_EQ(again.blocks[0].tool.node, file.blocks[0].tool.node);
}

TEST(DecisionJson, names_the_place_of_a_number_that_is_not_finite) {
    for (const char* text : {"nan", "inf", "-inf", "1e999", "0x1p+2000", "", "12 mm"}) {
        Json json = good();
        json["blocks"][0]["nodes"][1][2] = text;
        const auto problems = problems_of(json);
        ASSERT_EQ(problems.size(), 1U) << text;
        EXPECT_NE(problems[0].find("f: /blocks/0/nodes/1/2: "), std::string::npos) << problems[0];
        EXPECT_NE(problems[0].find("is not a finite number"), std::string::npos) << problems[0];
    }
    Json json = good();
    json["blocks"][0]["queries"][0]["p"][1] = nullptr;
    EXPECT_EQ(problems_of(json).size(), 1U);
}

TEST(DecisionJson, names_what_is_missing_or_wrong) {
    const auto complaint = [](const char* pointer, const Json& value) {
        Json json = good();
        json[Json::json_pointer(pointer)] = value;
        const auto problems = problems_of(json);
        return problems.empty() ? std::string() : problems[0];
    };
    EXPECT_EQ(complaint("/blocks/0/segments/0/0", 0), "");
    EXPECT_NE(complaint("/blocks/0/segments/0/0", 3).find("3 is not the index of a node: 0 to 2"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/segments/0/0", -1).find("is not the index"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/segments/0/0", 0.5).find("is not the index"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/segments/0", Json::array({0, 1, 2})).find("four node indices"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/normals", Json::array()).find("0 normals for 3 nodes"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/queries/0/gap", -1).find("is negative"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/queries/0", Json::object()).find("'p' is missing"), std::string::npos);
    EXPECT_NE(complaint("/blocks/0/answers", Json::array()).find("0 answers for 1 queries"), std::string::npos);
    EXPECT_NE(complaint("/blocks", 1).find("/blocks: 1 stands where a list is wanted"), std::string::npos);
}

TEST(DecisionJson, another_key_is_a_mistake_and_the_nearest_is_named) {
    const auto complaint = [](const char* pointer, const char* key) {
        Json json = good();
        json[Json::json_pointer(pointer)][key] = 1;
        const auto problems = problems_of(json);
        EXPECT_EQ(problems.size(), 1U) << key;
        return problems.at(0);
    };
    EXPECT_NE(complaint("/blocks/0/queries/0", "Depth")
                  .find("/blocks/0/queries/0/Depth: there is no such key, did you "
                        "mean 'depth'?; the keys are p, gap, depth, reach"),
              std::string::npos);
    EXPECT_NE(complaint("/blocks/0", "node").find("did you mean 'nodes'?"), std::string::npos);
    EXPECT_NE(complaint("", "units").find("f: /units: there is no such key; the keys are family, blocks"),
              std::string::npos);
}

TEST(DecisionJson, answers_are_within_the_tool) {
    const auto complaint = [](const char* answer) {
        Json json = good();
        json["blocks"][0]["answers"] = Json::array({Json::parse(answer)});
        const auto problems = problems_of(json);
        return problems.empty() ? std::string() : problems[0];
    };
    EXPECT_EQ(complaint(R"({"segment": 0, "triangle": 1, "side": -1, "kind": "contact"})"), "");
    EXPECT_EQ(complaint(R"({"segment": -1, "kind": "none"})"), "");
    EXPECT_NE(
        complaint(R"({"segment": 1, "triangle": 1, "side": 1, "kind": "contact"})").find("/answers/0/segment: 1 is"),
        std::string::npos);
    EXPECT_NE(complaint(R"({"segment": 0, "triangle": 5, "side": 1, "kind": "contact"})").find("/answers/0/triangle"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"segment": 0, "triangle": "1", "side": 1, "kind": "contact"})").find("\"1\" is not"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"segment": 0, "triangle": 1, "side": 1, "kind": "kontakt"})").find("'kontakt'"),
              std::string::npos);
    EXPECT_NE(complaint(R"({"segment": 99999999999999999999, "kind": "contact"})").find("/answers/0/segment"),
              std::string::npos);
}

}  // namespace
}  // namespace type21
