// /SENSOR cards: what each says, and which of them are read at all.
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

/// A drive on a sensor, so that the sensor is read.
std::string drive_on(const std::string& sensor) {
    return "/IMPVEL/9\nd\n" + ints({"1", "X", "0", sensor, "3", "0", "0"}) + reals({"", "", "", ""});
}

const Sensor& sensor(const Resolved& r, Id id) {
    for (const Sensor& one : r.model.sensors) {
        if (one.id == id) return one;
    }
    throw std::logic_error("no such sensor");
}

/// The line of DIST or INTER: two columns of 10, then Dmin or Fmin, Dmax or Fmax, Tmin.
std::string limits(const std::string& first, const std::string& second, const std::vector<std::string>& values) {
    return fmt::format("{:>10}{:>10}", first, second) + reals(values);
}

std::string time_sensor(const std::string& id, const std::string& delay, const std::string& stop = "") {
    return "/SENSOR/TIME/" + id + "\nt\n" + reals({delay}) + reals({stop});
}

TEST(Sensor, TimeWindow) {
    const Resolved r = resolved(with_cards(time_sensor("4", "1e-4", "2e-4") + drive_on("4")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(sensor(r, 4).kind, Sensor::Kind::time);
    EXPECT_EQ(sensor(r, 4).delay, 1e-4);
    EXPECT_EQ(sensor(r, 4).stop, 2e-4);
    EXPECT_EQ(sensor(resolved(with_cards("/SENSOR/TIME/4\nt\n" + reals({"1e-4"}) + drive_on("4"))), 4).stop, 1e30);
}

TEST(Sensor, TheStopTimeCameWithVersion2023) {
    std::string text = with_cards(time_sensor("4", "1e-4", "2e-4") + drive_on("4"));
    text = replaced(text, "      2025         0", "      2021         0");
    const Resolved r = resolved(text);
    EXPECT_EQ(r.model.sensors.at(0).stop, 1e30);
    EXPECT_NE(find_rule(r.problems, "what follows is not read"), nullptr);
}

// With the line of Tdelay and without it, as older decks have it.
TEST(Sensor, LogicalSensorsLookAtOthers) {
    const std::string times = time_sensor("4", "1e-4") + time_sensor("5", "2e-4");
    for (const std::string& delay : {std::string(), reals({"3e-4"})}) {
        const Resolved r =
            resolved(with_cards("/SENSOR/AND/8\na\n" + delay + ints({"7", "6"}) + "/SENSOR/NOT/7\nn\n" + delay +
                                ints({"5"}) + "/SENSOR/OR/6\no\n" + delay + ints({"4", "5"}) + times + drive_on("8")));
        EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
        EXPECT_EQ(sensor(r, 8).kind, Sensor::Kind::all);
        EXPECT_EQ(sensor(r, 8).of, (std::vector<int>{1, 2})) << "in the order of the deck: 8, 7, 6, 4, 5";
        EXPECT_EQ(sensor(r, 7).kind, Sensor::Kind::none);
        EXPECT_EQ(sensor(r, 7).of, std::vector<int>{4});
        EXPECT_EQ(sensor(r, 6).kind, Sensor::Kind::any);
        EXPECT_EQ(sensor(r, 6).of, (std::vector<int>{3, 4}));
        for (const Id id : {8, 7, 6})
            EXPECT_EQ(sensor(r, id).delay, delay.empty() ? 0 : 3e-4);
        EXPECT_EQ(r.model.sensor_order, (std::vector<int>{4, 1, 3, 2, 0})) << "each behind those that it looks at";
    }
}

TEST(Sensor, DistanceAndForce) {
    const std::string unit = "/UNIT/3\nSI\n" + reals({"kg", "m", "s"});
    const Resolved r = resolved(with_cards(
        unit + "/SENSOR/DIST/4/3\nd\n" + reals({"2e-4"}) + ints({"1", "201"}) + "/SENSOR/DIST/5\nd\n" + reals({"0.0"}) +
        limits("1", "201", {"2.0", "12.0", "0.0003"}) + "/SENSOR/INTER/6\nf\n" + reals({"0.0"}) +
        limits("1", "TF", {"", "7.0"}) + "/SENSOR/OR/7\no\n" + ints({"5", "6"}) + drive_on("7")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems) << "nothing uses 4, which has no limit";
    const Sensor& distance = sensor(r, 5);
    EXPECT_EQ(r.model.nodes.id[static_cast<size_t>(distance.node_a)], 1);
    EXPECT_EQ(r.model.nodes.id[static_cast<size_t>(distance.node_b)], 201);
    EXPECT_EQ(distance.low, 2);
    EXPECT_EQ(distance.high, 12);
    EXPECT_EQ(distance.lasting, 3e-4);
    const Sensor& force = sensor(r, 6);
    EXPECT_EQ(force.interface, 0);
    EXPECT_EQ(force.part, Sensor::Force::tangential);
    EXPECT_EQ(force.low, -1e30) << "a blank limit does not act";
    EXPECT_EQ(force.high, 7);
}

TEST(Sensor, ForcesAndDistancesAreInTheUnitsOfTheirCard) {
    const std::string unit = "/UNIT/3\nSI\n" + reals({"kg", "m", "ms"});
    const Resolved r = resolved(with_cards(unit + "/SENSOR/DIST/4/3\nd\n" + reals({"1.0"}) +
                                           limits("1", "201", {"2.0", "0.0", "3.0"}) + "/SENSOR/INTER/5/3\nf\n" +
                                           reals({"0.0"}) + limits("1", "Z", {"0.0", "7.0e-06"}) + "/SENSOR/OR/7\no\n" +
                                           ints({"4", "5"}) + drive_on("7")));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_DOUBLE_EQ(sensor(r, 4).delay, 1e-3);
    EXPECT_DOUBLE_EQ(sensor(r, 4).low, 2000) << "mm";
    EXPECT_DOUBLE_EQ(sensor(r, 4).lasting, 3e-3);
    EXPECT_DOUBLE_EQ(sensor(r, 5).high, 7) << "7e-6 kg m/ms^2 are 7 N";
}

// One that nothing uses does no harm, whatever its kind and whatever stands in it.
TEST(Sensor, OnesThatNothingUsesAreNotRead) {
    const Resolved r =
        resolved(with_cards("/SENSOR/ACCE/4\nx\n/SENSOR/GAUGE/5\nsomething else\n" + ints({"1", "2", "3"}) +
                            "/SENSOR/OR/6\no\n" + ints({"6", "99"}) + "/SENSOR/DIST/7\nd\n" + reals({"bad"})));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_TRUE(r.model.sensor_order.empty());
}

TEST(Sensor, OtherKindsAreRefusedByNameWhereACardUsesThem) {
    const Problem direct = only(resolved(with_cards("/SENSOR/ACCE/4\nx\n" + drive_on("4"))).problems);
    EXPECT_EQ(direct.card, "/SENSOR/ACCE/4");
    EXPECT_NE(direct.rule.find("/IMPVEL/9 uses it"), std::string::npos) << direct.rule;
    const Problem behind =
        only(resolved(with_cards("/SENSOR/RWALL/4\nx\n/SENSOR/NOT/5\nn\n" + ints({"4"}) + drive_on("5"))).problems);
    EXPECT_EQ(behind.card, "/SENSOR/RWALL/4");
    EXPECT_NE(behind.rule.find("/SENSOR/NOT/5 uses it"), std::string::npos) << behind.rule;
    std::string text = with_cards("/SENSOR/TEMP/4\nx\n");
    text = replaced(text, ints({"1", "2"}) + std::string(10, '\n'),
                    ints({"1", "2"}) + "\n\n\n\n" + fmt::format("{:>60}\n", "4") + std::string(5, '\n'));
    const Problem interface = only(resolved(text).problems);
    EXPECT_NE(interface.rule.find("/INTER/TYPE21/1 uses it"), std::string::npos) << interface.rule;
}

TEST(Sensor, OnesThatLookAtThemselvesAreErrors) {
    const auto rule = [](const std::string& cards) {
        return only(resolved(with_cards(cards + drive_on("4"))).problems).rule;
    };
    EXPECT_NE(rule("/SENSOR/NOT/4\nn\n" + ints({"4"})).find("looks at itself"), std::string::npos);
    EXPECT_NE(rule("/SENSOR/OR/4\no\n" + ints({"5", "6"}) + "/SENSOR/AND/5\na\n" + ints({"6", "7"}) +
                   "/SENSOR/NOT/6\nn\n" + ints({"7"}) + "/SENSOR/NOT/7\nn\n" + ints({"5"}))
                  .find("looks at itself"),
              std::string::npos);
}

TEST(Sensor, MistakesAreNamed) {
    const auto field = [](const std::string& card) {
        return only(resolved(with_cards(card + drive_on("4"))).problems).field;
    };
    EXPECT_EQ(field("/SENSOR/OR/4\no\n" + ints({"77", "5"}) + time_sensor("5", "0.0")), "sens_ID1");
    EXPECT_EQ(field("/SENSOR/NOT/4\nn\n" + reals({"-1.0"}) + ints({"5"}) + time_sensor("5", "0.0")), "Tdelay");
    EXPECT_EQ(field("/SENSOR/DIST/4\nd\n" + reals({"0.0"}) + limits("1", "77", {"1.0"})), "node_ID2");
    EXPECT_EQ(field("/SENSOR/DIST/4\nd\n" + reals({"0.0"}) + ints({"1", "201"})), "Dmax");
    EXPECT_EQ(field("/SENSOR/DIST/4\nd\n" + reals({"0.0"}) + limits("1", "201", {"9.0", "3.0"})), "Dmin");
    EXPECT_EQ(field("/SENSOR/INTER/4\nf\n" + reals({"0.0"}) + limits("55", "NF", {"1.0"})), "int_ID");
    EXPECT_EQ(field("/SENSOR/INTER/4\nf\n" + reals({"0.0"}) + limits("1", "QQ", {"1.0"})), "Dir");
    EXPECT_EQ(field("/SENSOR/AND/4\n"), "") << "the card ends early";
}

// A chain as long as a deck is no deep recursion.
TEST(Sensor, ALongChainIsRead) {
    std::string cards = time_sensor("100000", "1e-4");
    const int links = 5000;
    for (int i = 1; i <= links; ++i)
        cards += fmt::format("/SENSOR/NOT/{}\nn\n{:>10}\n", 100000 - i, 100001 - i);
    const Resolved r = resolved(with_cards(cards + drive_on(std::to_string(100000 - links))));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.model.sensor_order.size(), static_cast<size_t>(links) + 1);
}

}  // namespace
}  // namespace type21
