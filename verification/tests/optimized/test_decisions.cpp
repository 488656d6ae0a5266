// The truth sets of cases/decisions: answers of rational arithmetic on small tools.
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "optimized/projection/query.h"

namespace type21 {
namespace {

using nlohmann::json;

double number(const json& text) {
    return std::strtod(text.get<std::string>().c_str(), nullptr);
}
Vec3 vector(const json& j) {
    return {number(j[0]), number(j[1]), number(j[2])};
}
std::string word(Kind kind) {
    return kind == Kind::none ? "none" : (kind == Kind::contact ? "contact" : "proximity");
}

TEST(Decisions, AreThoseOfRationalArithmetic) {
    int queries = 0, taken = 0;
    for (const auto& file : std::filesystem::directory_iterator(TYPE21_SOURCE_DIR "/cases/decisions")) {
        if (file.path().extension() != ".json") continue;
        std::ifstream in(file.path());
        const json family = json::parse(in);
        for (const json& block : family["blocks"]) {
            std::vector<Vec3> nodes, normals;
            for (const json& x : block["nodes"])
                nodes.push_back(vector(x));
            for (const json& n : block["normals"])
                normals.push_back(vector(n));
            const auto segments = block["segments"].get<std::vector<std::array<int, 4>>>();
            for (size_t i = 0; i < block["queries"].size(); ++i) {
                const json& q = block["queries"][i];
                const json& answer = block["answers"][i];
                const Decision d = optimized::decide_query(nodes, normals, segments, vector(q["p"]), number(q["gap"]),
                                                           number(q["depth"]), number(q["reach"]));
                ++queries;
                ASSERT_EQ(word(d.kind), answer["kind"].get<std::string>()) << file.path() << " " << q.dump();
                if (d.kind == Kind::none) continue;
                ++taken;
                ASSERT_EQ(d.segment, answer["segment"].get<int>()) << file.path() << " " << q.dump();
                ASSERT_EQ(d.triangle, answer["triangle"].get<int>()) << file.path() << " " << q.dump();
                ASSERT_EQ(d.side, answer["side"].get<int>()) << file.path() << " " << q.dump();
            }
        }
    }
    // The sets hold 14 families of 100 queries, most of which touch, and five by hand.
    EXPECT_EQ(queries, 1405);
    EXPECT_GT(taken, 700);
}

TEST(Decisions, RefuseWhatIsNotANumber) {
    const std::vector<Vec3> nodes{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const std::vector<Vec3> normals(3, Vec3(0, 0, 1));
    const double nan = std::nan("");
    EXPECT_THROW(optimized::decide_query(nodes, normals, {{0, 1, 2, 2}}, {nan, 0, 0}, 1, 1, 0), std::invalid_argument);
    EXPECT_THROW(optimized::decide_query(nodes, normals, {{0, 1, 7, 7}}, {0, 0, 0}, 1, 1, 0), std::invalid_argument);
}

}  // namespace
}  // namespace type21
