/// @file /TRANSFORM, each kind on one node whose new place is worked out by hand.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "selecting.h"

namespace type21 {
namespace {

using namespace test;

using Ids = std::vector<Id>;

/// Line 1 of most kinds: grnod_ID, three reals, two nodes and sub_ID.
std::string transform(const std::string& keyword, const std::vector<std::string>& numbers,
                      const std::string& node1 = "", const std::string& node2 = "", const std::string& group = "10") {
    return "/TRANSFORM/" + keyword + "\nt\n" + fmt::format("{:>10}", group) + reals(numbers).substr(0, 60) +
           ints({node1, node2});
}

std::string second_line(const std::vector<std::string>& numbers) {
    return fmt::format("{:>10}", "") + reals(numbers);
}

/// Node 2, at (10, 0, 0), after these cards. Where it lands may be worth a warning.
Vec3 moved(const std::string& cards) {
    const Selecting r(with_cards(list_card("/GRNOD/NODE/10", {"2"}) + cards));
    EXPECT_FALSE(r.problems.has_errors()) << all_of(r.problems);
    return r.model.nodes.position.at(1);
}

bool at(const Vec3& x, double a, double b, double c) {
    return (x - Vec3(a, b, c)).norm() < 1e-12;
}

TEST(Transforms, EachKind) {
    EXPECT_TRUE(at(moved(transform("TRA/1", {"1", "2", "3"})), 11, 2, 3));
    EXPECT_TRUE(at(moved(transform("TRA/1", {"7", "7", "7"}, "1", "4")), 10, 10, 0)) << "from node 1 to node 4";
    EXPECT_TRUE(at(moved(transform("ROT/1", {"0", "0", "0"}) + second_line({"0", "0", "5", "90"})), 0, 10, 0))
        << "by the right-hand rule, in degrees";
    EXPECT_TRUE(at(moved(transform("ROT/1", {"10", "10", "0"}) + second_line({"10", "10", "1", "180"})), 10, 20, 0));
    EXPECT_TRUE(at(moved(transform("ROT/1", {"", "", ""}, "1", "4") + second_line({"", "", "", "90"})), 0, 0, -10))
        << "about the line from node 1 to node 4, the y axis";
    EXPECT_TRUE(at(moved(transform("SYM/1", {"4", "0", "0"}) + second_line({"5", "0", "0"})), -2, 0, 0));
    EXPECT_TRUE(at(moved(transform("SCA/1", {"3", "2", ""})), 30, 0, 0)) << "about the origin; blank means 1";
    EXPECT_TRUE(at(moved(transform("SCA/1", {"3", "2", "0"}, "5")), -10, 0, 0)) << "about node 5 at (20, 0, 0)";
    EXPECT_TRUE(at(moved("/TRANSFORM/MATRIX/1\nt\n" + ints({"10"}) + reals({"0", "0", "1", "5"}) +
                         reals({"1", "0", "0", "6"}) + reals({"0", "1", "0", "7"})),
                   5, 16, 7));
}

TEST(Transforms, FollowOneAnotherInTheOrderOfTheDeck) {
    const std::string up = transform("TRA/1", {"1", "0", "0"});
    const std::string turn = transform("ROT/2", {"0", "0", "0"}) + second_line({"0", "0", "1", "90"});
    EXPECT_TRUE(at(moved(up + turn), 0, 11, 0));
    EXPECT_TRUE(at(moved(turn + up), 1, 10, 0));
    EXPECT_TRUE(at(moved(up + transform("TRA/2", {"", "", ""}, "1", "2")), 22, 0, 0))
        << "a node is where it is by then";
}

TEST(Transforms, InTheUnitsOfTheCard) {
    const std::string metres = "/UNIT/5\nm\n" + reals({"kg", "m", "s"});
    EXPECT_TRUE(at(moved(metres + transform("TRA/1/5", {"0.001", "0", "0"})), 11, 0, 0));
}

TEST(Transforms, BoxesSeeTheNodesThatHaveMoved) {
    const std::string box = "/BOX/RECTA/1\nb\n" + ints({"0"}) + reals({"99", "-1", "-1"}) + reals({"101", "1", "1"});
    Selecting s(with_cards(list_card("/GRNOD/NODE/10", {"2"}) + transform("TRA/1", {"90", "0", "0"}) + box +
                           list_card("/GRNOD/BOX/11", {"1"})));
    EXPECT_EQ(s.nodes(11), (Ids{2}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Transforms, MistakesAreNamed) {
    const auto problem = [](const std::string& cards) {
        return only(Selecting(with_cards(list_card("/GRNOD/NODE/10", {"2"}) + cards)).problems);
    };
    EXPECT_EQ(problem(transform("TRA/1", {"1", "2", "3"}, "1")).field, "node_ID2");
    EXPECT_EQ(problem(transform("TRA/1", {"1", "2", "3"}, "1", "999")).value, "999");
    EXPECT_EQ(problem(transform("TRA/1", {"1", "2", "3"}, "", "", "99")).field, "grnod_ID");
    EXPECT_EQ(problem(transform("TRA/1", {"1", "2", "3"}, "", "", "")).field, "grnod_ID");
    EXPECT_NE(problem(transform("SYM/1", {"1", "2", "3"}) + second_line({"1", "2", "3"})).rule.find("no direction"),
              std::string::npos);
    EXPECT_NE(
        problem(transform("ROT/1", {"1", "2", "3"}) + second_line({"1", "2", "3", "9"})).rule.find("no direction"),
        std::string::npos);
    EXPECT_EQ(problem("/TRANSFORM/POSITION/1\nt\n").card, "/TRANSFORM/POSITION");
    const std::string box = "/BOX/SPHER/1\nb\n" + fmt::format("{:>10}{:>30}\n", "1", "3.0");
    EXPECT_NE(problem(box + list_card("/GRNOD/BOX/11", {"1"}) + transform("TRA/1", {"1", "2", "3"}, "", "", "11"))
                  .rule.find("before"),
              std::string::npos);
}

}  // namespace
}  // namespace type21
