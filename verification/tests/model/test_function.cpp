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

TEST(Sensor, TimeWindow) {
    const Resolved r = resolved(with_cards("/SENSOR/TIME/4\nwindow\n" + reals({"1e-4"}) + reals({"2e-4"}) +
                                           "/SENSOR/TIME/5\non\n" + reals({"3e-4"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.sensors.size(), 2U);
    EXPECT_FALSE(r.model.sensors[0].on(0.9e-4));
    EXPECT_TRUE(r.model.sensors[0].on(1e-4));
    EXPECT_FALSE(r.model.sensors[0].on(2e-4));
    EXPECT_TRUE(r.model.sensors[1].on(1e9));
}

TEST(Sensor, TheStopTimeCameWithVersion2023) {
    std::string text = with_cards("/SENSOR/TIME/4\nwindow\n" + reals({"1e-4"}) + reals({"2e-4"}));
    text = replaced(text, "      2025         0", "      2021         0");
    const Resolved r = resolved(text);
    EXPECT_EQ(r.model.sensors.at(0).stop, 1e30);
    EXPECT_NE(find_rule(r.problems, "what follows is not read"), nullptr);
}

TEST(Sensor, OtherKindsAreRefusedByNameWhereTheyAreUsed) {
    const std::string sensor = "/SENSOR/ACCE/4\nx\n";
    EXPECT_TRUE(resolved(with_cards(sensor)).problems.list().empty());
    const Problem p = only(resolved(with_cards(sensor + "/CLOAD/1\nf\n" + ints({"1", "Z", "0", "4", "3"}))).problems);
    EXPECT_NE(p.rule.find("/SENSOR/ACCE/4"), std::string::npos) << p.rule;
}

}  // namespace
}  // namespace type21
