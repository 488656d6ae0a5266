#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

TEST(Function, LinearBetweenThePointsAndBeyondBothEnds) {
    const Function f{1, "", {0, 2, 3}, {1, 5, 4}};
    EXPECT_DOUBLE_EQ(f(0), 1);
    EXPECT_DOUBLE_EQ(f(1), 3);
    EXPECT_DOUBLE_EQ(f(2), 5);
    EXPECT_DOUBLE_EQ(f(2.5), 4.5);
    EXPECT_DOUBLE_EQ(f(-1), -1);
    EXPECT_DOUBLE_EQ(f(5), 2);
}

TEST(Function, OnePointIsAConstant) {
    const Function f{1, "", {3}, {7}};
    EXPECT_EQ(f(-100), 7);
    EXPECT_EQ(f(100), 7);
}

TEST(Function, IsReadFromTheDeck) {
    const Resolved r = resolved(with_cards("/FUNCT/9\nramp\n" + reals({"-1.5", "2.0"}) + "\n" + reals({"0.5", "4.0"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.functions.size(), 2U);
    EXPECT_EQ(r.model.functions[1].title, "ramp");
    EXPECT_EQ(r.model.functions[1].x, (std::vector<double>{-1.5, 0.5}));
    EXPECT_EQ(r.model.functions[1].y, (std::vector<double>{2, 4}));
}

TEST(Function, AbscissaeAscend) {
    for (const char* second : {"1.0", "0.5"}) {
        const Resolved r = resolved(with_cards("/FUNCT/9\nf\n" + reals({"1.0", "0.0"}) + reals({second, "0.0"})));
        const Problem p = only(r.problems);
        EXPECT_EQ(p.field, "X");
        EXPECT_NE(p.rule.find("ascend"), std::string::npos);
    }
}

TEST(Function, WithoutAPointIsAnError) {
    EXPECT_EQ(only(resolved(with_cards("/FUNCT/9\nf\n")).problems).card, "/FUNCT/9");
}

TEST(Function, MoveFunctScalesAndShifts) {
    const std::string f = "/FUNCT/9\nf\n" + reals({"1.0", "10.0"}) + reals({"2.0", "30.0"});
    const Resolved all = resolved(with_cards("/MOVE_FUNCT/9\nmoved\n" + reals({"2.0", "0.5", "-1.0", "4.0"}) + f));
    EXPECT_TRUE(all.problems.list().empty()) << all_of(all.problems);
    EXPECT_EQ(all.model.functions.at(1).x, (std::vector<double>{1, 3}));
    EXPECT_EQ(all.model.functions[1].y, (std::vector<double>{9, 19}));
    const Resolved blank = resolved(with_cards(f + "/MOVE_FUNCT/9\nmoved\n" + reals({"", "", "1.0", ""})));
    EXPECT_EQ(blank.model.functions.at(1).x, (std::vector<double>{2, 3})) << "a blank scale is 1";
    EXPECT_EQ(blank.model.functions[1].y, (std::vector<double>{10, 30}));
}

TEST(Function, MoveFunctMistakesAreNamed) {
    const std::string f = "/FUNCT/9\nf\n" + reals({"1.0", "10.0"}) + reals({"2.0", "30.0"});
    const auto field = [&](const std::string& id, const std::vector<std::string>& line) {
        return only(resolved(with_cards(f + "/MOVE_FUNCT/" + id + "\nm\n" + reals(line))).problems).field;
    };
    EXPECT_EQ(field("8", {"1.0"}), "fct_ID");
    EXPECT_EQ(field("9", {"-1.0"}), "Ascale_x") << "the abscissae would descend";
    EXPECT_EQ(field("9", {"1.0", "1.0", "1e20"}), "Ashift_x") << "the digits of the abscissae are gone";
}

}  // namespace
}  // namespace type21
