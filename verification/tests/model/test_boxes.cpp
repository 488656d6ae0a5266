/// @file /BOX and what it selects, on the driven scene: nodes 1 to 5 and 101 to 104, shells 1 and 3, triangle 2.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/model/box.h"
#include "selecting.h"

namespace type21 {
namespace {

using namespace test;

using Ids = std::vector<Id>;

std::string block_card(const std::string& id, const std::vector<std::string>& low,
                       const std::vector<std::string>& high) {
    return "/BOX/RECTA/" + id + "\nb\n" + ints({"0", "0", "0"}) + reals(low) + reals(high);
}

TEST(Boxes, BordersBelongToThem) {
    const Box block{Box::Shape::block, Vec3(1, 1, 1), Vec3(0, 0, 0), 0, Mat3::Identity()};
    EXPECT_TRUE(block.contains({1, 0, 0.5})) << "the corners may come in any order";
    EXPECT_FALSE(block.contains({1.0000001, 0, 0.5}));
    const Box sphere{Box::Shape::sphere, Vec3(0, 0, 1), Vec3(0, 0, 0), 4, Mat3::Identity()};
    EXPECT_TRUE(sphere.contains({2, 0, 1}));
    EXPECT_FALSE(sphere.contains({2, 0, 1.001}));
    const Box cylinder{Box::Shape::cylinder, Vec3(0, 0, 0), Vec3(0, 0, 10), 4, Mat3::Identity()};
    EXPECT_TRUE(cylinder.contains({2, 0, 10}));
    EXPECT_FALSE(cylinder.contains({2, 0, 10.001})) << "it ends with its axis";
    EXPECT_FALSE(cylinder.contains({2.001, 0, 5}));
}

TEST(Boxes, SelectNodesShellsAndSegments) {
    Selecting s(with_cards(block_card("1", {"0", "0", "0"}, {"10", "10", "1"}) + list_card("/GRNOD/BOX/10", {"1"}) +
                           list_card("/GRSHEL/BOX/11", {"1"}) + list_card("/GRSH3N/BOX/12", {"1"}) +
                           list_card("/GRSH3N/BOX2/13", {"1"}) + list_card("/SURF/BOX/14", {"-1"}) +
                           list_card("/SURF/BOX2/EXT/15", {"1"})));
    EXPECT_EQ(s.nodes(10), (Ids{1, 2, 3, 4}));
    EXPECT_EQ(s.shells(11), (Ids{1}));
    EXPECT_EQ(s.sh3n(12), (Ids{})) << "node 5 lies outside";
    EXPECT_EQ(s.sh3n(13), (Ids{2})) << "one node is enough";
    EXPECT_EQ(s.segments(14), "4 3 2 1");
    EXPECT_EQ(s.segments(15), "1 2 3 4, 2 5 3 3");
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Boxes, OfTwoNodesACylinderAndASphere) {
    const std::string diameter = "                25.0";
    Selecting s(with_cards("/BOX/RECTA/1\nb\n" + ints({"101", "103"}) + "/BOX/CYLIN/2\nb\n" + ints({"", "", ""}) +
                           list_card("/GRNOD/BOX/10", {"1"}) + "/BOX/CYLIN/3\nb\n" + ints({"1", "4"}) +
                           list_card("/GRNOD/BOX/11", {"4"}) + "/BOX/CYLIN/4\nb\n" +
                           ints({"1", "4", "0"}).substr(0, 30) + diameter + "\n" + list_card("/GRNOD/BOX/12", {"5"}) +
                           "/BOX/SPHER/5\nb\n" + fmt::format("{:>10}{:>10}{:>20}\n", "", "", "21.0") +
                           reals({"15.0", "0.0", "0.0"})));
    EXPECT_EQ(s.nodes(10), (Ids{101, 102, 103, 104}));
    EXPECT_EQ(s.nodes(11), (Ids{1, 2, 3, 4, 201})) << "radius 12.5 about x = 0, z = 0; 101 and 102 lie beyond the ends";
    EXPECT_EQ(s.nodes(12), (Ids{2, 5})) << "node 3 is 11.2 mm away";
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Boxes, OfBoxes) {
    const std::string boxes = block_card("1", {"-1", "-1", "-1"}, {"11", "11", "1"}) +
                              block_card("2", {"19", "-1", "-1"}, {"21", "1", "1"}) +
                              block_card("3", {"-1", "-1", "-1"}, {"1", "1", "1"}) +
                              list_card("/BOX/BOX/4", {"1", "2", "-3"}) + list_card("/BOX/BOX/5", {"4", "3"});
    Selecting s(with_cards(boxes + list_card("/GRNOD/BOX/10", {"4"}) + list_card("/GRNOD/BOX/11", {"5"})));
    EXPECT_EQ(s.nodes(10), (Ids{2, 3, 4, 5}));
    EXPECT_EQ(s.nodes(11), (Ids{1, 2, 3, 4, 5}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Boxes, AlongASkew) {
    // Y' = (1, 1, 0), Z' = z: X' = Y' x Z' = (1, -1, 0). The block is a square on its corner with the diagonal from
    // node 1 to (20, 0, 0): node 2 lies in its middle, node 4 outside.
    const std::string skew =
        "/SKEW/FIX/12\ns\n" + reals({"0", "0", "0"}) + reals({"1", "1", "0"}) + reals({"0", "0", "1"});
    const std::string box = "/BOX/RECTA/1\nb\n" + ints({"0", "0", "12"}) + reals({"0", "0", "-1"}) +
                            reals({"20.000001", "0", "1"}) + list_card("/GRNOD/BOX/10", {"1"});
    Selecting s(with_cards(skew + box));
    EXPECT_EQ(s.nodes(10), (Ids{1, 2, 3, 5})) << "node 3, at (10, 10, 0), is a corner";
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Boxes, InTheirOwnUnits) {
    Selecting s(with_cards("/UNIT/5\nm\n" + reals({"kg", "m", "s"}) + "/BOX/SPHER/1/5\nb\n" +
                           fmt::format("{:>10}{:>10}{:>20}\n", "", "", "0.001") + reals({"0.01", "0.01", "0"}) +
                           list_card("/GRNOD/BOX/10", {"1"})));
    EXPECT_EQ(s.nodes(10), (Ids{3})) << "10 mm, diameter 1 mm";
}

TEST(Boxes, MistakesAreNamed) {
    const auto problem = [](const std::string& box) {
        Selecting s(with_cards(box + list_card("/GRNOD/BOX/10", {"1"})));
        s.nodes(10);
        return only(s.problems);
    };
    EXPECT_EQ(
        problem("/BOX/RECTA/1\nb\n" + ints({"0", "0", "7"}) + reals({"0", "0", "0"}) + reals({"1", "1", "1"})).field,
        "skew_ID");
    EXPECT_EQ(problem("/BOX/RECTA/1\nb\n" + ints({"101", "0"}) + reals({"0", "0", "0"}) + reals({"1", "1", "1"})).field,
              "node_ID2");
    EXPECT_EQ(problem("/BOX/RECTA/1\nb\n" + ints({"101", "999"})).value, "999");
    EXPECT_EQ(problem("/BOX/RECTA/1\nb\n" + ints({"0", "0"}) + reals({"0", "0", "0"})).field, "X2");
    EXPECT_EQ(problem("/BOX/SPHER/1\nb\n" + ints({"101"})).field, "Diam");
    EXPECT_EQ(problem("/BOX/SPHER/1\nb\n" + fmt::format("{:>10}{:>10}{:>20}\n", "101", "", "-3.0")).value, "-3 mm");
    EXPECT_NE(problem("/BOX/CYLIN/1\nb\n" + fmt::format("{:>10}{:>10}{:>20}\n", "101", "101", "3.0")).rule.find("axis"),
              std::string::npos);
    EXPECT_EQ(problem("/BOX/CONE/1\nb\n").value, "CONE");
    EXPECT_EQ(problem("").field, "box_ID");
}

}  // namespace
}  // namespace type21
