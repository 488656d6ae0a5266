/// @file /SET/GENERAL as a node group, a group of shells or parts and a surface, on the driven scene.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "selecting.h"

namespace type21 {
namespace {

using namespace test;

using Ids = std::vector<Id>;

std::string clause(const std::string& word, const std::vector<std::string>& ids) {
    return fmt::format("{:<10}", word) + ints(ids);
}

std::string set_card(const std::string& id, const std::string& clauses) {
    return "/SET/GENERAL/" + id + "\ns\n" + clauses;
}

TEST(Sets, StandForGroupsAndSurfaces) {
    Selecting s(with_cards(set_card("30", clause("PART", {"1"}) + clause("NODE", {"101", "102"})) +
                           list_card("/GRNOD/GRNOD/10", {"30"}) + list_card("/SURF/SURF/11", {"-30"}) +
                           list_card("/GRSH3N/GRSH3N/12", {"30"}) + list_card("/GRPART/GRPART/13", {"30"}) +
                           list_card("/GRSHEL/GRSHEL/14", {"30"})));
    EXPECT_EQ(s.nodes(30), (Ids{1, 2, 3, 4, 5, 101, 102})) << "by its own id, as a drive names it";
    EXPECT_EQ(s.nodes(10), s.nodes(30));
    EXPECT_EQ(s.segments(30), "1 2 3 4, 2 5 3 3");
    EXPECT_EQ(s.segments(11), "4 3 2 1, 5 2 3 3");
    EXPECT_EQ(s.sh3n(12), (Ids{2}));
    EXPECT_EQ(s.shells(14), (Ids{1}));
    EXPECT_EQ(s.parts(13), (Ids{1}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Sets, ClausesOfEveryKind) {
    const auto nodes = [](const std::string& clauses) {
        const std::string others = set_card("31", clause("NODE", {"3"})) + "/SUBSET/7\nx\n" + "/BOX/RECTA/8\nb\n" +
                                   ints({"0"}) + reals({"-1", "-1", "-1"}) + reals({"1", "11", "1"});
        Selecting s(with_cards(others + set_card("30", clauses)));
        const Ids found = s.nodes(30);
        EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
        return found;
    };
    EXPECT_EQ(nodes(clause("NODE", {"1", "2"}) + clause("", {"3"})), (Ids{1, 2, 3})) << "ids go on on the next line";
    EXPECT_EQ(nodes(clause("NODE_G", {"2", "5"})), (Ids{2, 3, 4, 5}));
    EXPECT_EQ(nodes(clause("NODE_G", {"1", "5", "3"})), (Ids{1, 4}));
    EXPECT_EQ(nodes(clause("node", {"1"})), (Ids{1})) << "in small letters, too";
    EXPECT_EQ(nodes(clause("SHELL", {"1"})), (Ids{1, 2, 3, 4}));
    EXPECT_EQ(nodes(clause("SH3N", {"2"})), (Ids{2, 3, 5}));
    EXPECT_EQ(nodes(clause("ELEM_G", {"1", "2"})), (Ids{1, 2, 3, 4, 5}));
    EXPECT_EQ(nodes(clause("ELEM", {"2"})), (Ids{2, 3, 5}));
    EXPECT_EQ(nodes(clause("MAT", {"1"})), (Ids{1, 2, 3, 4, 5}));
    EXPECT_EQ(nodes(clause("PROP", {"2"})), (Ids{101, 102, 103, 104}));
    EXPECT_EQ(nodes(clause("PART_G", {"2", "9"})), (Ids{101, 102, 103, 104}));
    EXPECT_EQ(nodes(clause("SUBSET", {"7"})), (Ids{}));
    EXPECT_EQ(nodes(clause("BOX", {"8"})), (Ids{1, 4}));
    EXPECT_EQ(nodes(clause("SEG", {"1", "1", "2", "3", "4"})), (Ids{1, 2, 3, 4}));
    EXPECT_EQ(nodes(clause("SEG", {"2", "5", "3"})), (Ids{2, 3, 5}));
    EXPECT_EQ(nodes(clause("SET", {"31"}) + clause("NODE", {"5"})), (Ids{3, 5}));
    EXPECT_EQ(nodes(clause("ALL", {})).size(), 10U);
}

TEST(Sets, ClausesThatTakeAwayActInTheirOrder) {
    const auto nodes = [](const std::string& clauses) {
        Selecting s(with_cards(set_card("30", clauses)));
        const Ids found = s.nodes(30);
        EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
        return found;
    };
    for (const std::string word : {"DNODE", "NODE_D", "-NODE"}) {
        EXPECT_EQ(nodes(clause("PART", {"1"}) + clause(word, {"5"})), (Ids{1, 2, 3, 4})) << word;
        EXPECT_EQ(nodes(clause(word, {"5"}) + clause("PART", {"1"})), (Ids{1, 2, 3, 4, 5})) << word;
    }
    EXPECT_EQ(nodes(clause("PART", {"1"}) + clause("DNODE_G", {"1", "3"})), (Ids{4, 5}));
    EXPECT_EQ(nodes(clause("PART", {"1"}) + clause("NODE_I", {"4", "5", "101"})), (Ids{4, 5}));
    EXPECT_EQ(nodes(clause("PART", {"1"}) + "NODE      D         " + ints({"5"})), (Ids{1, 2, 3, 4}))
        << "the letter in a field of its own";
}

TEST(Sets, ASurfaceLosesTheShellsThatAreTakenAway) {
    Selecting s(with_cards(set_card("30", clause("PART", {"1"}) + clause("SH3N_D", {"2"})) +
                           set_card("31", clause("SHELL", {"1"}) + clause("SEG", {"9", "2", "5", "3", "3"})) +
                           set_card("32", clause("SET", {"31"}) + clause("DSEG", {"9", "5", "3", "2", "2"})) +
                           set_card("33", clause("PART", {"1"}) + clause("NODE_D", {"5"}))));
    EXPECT_EQ(s.segments(30), "1 2 3 4");
    EXPECT_EQ(s.nodes(30), (Ids{1, 4})) << "the nodes of a shell go with it, shared ones too";
    EXPECT_EQ(s.segments(31), "1 2 3 4, 2 5 3 3");
    EXPECT_EQ(s.segments(32), "1 2 3 4");
    EXPECT_EQ(s.segments(33), "1 2 3 4, 2 5 3 3") << "a node takes no shell with it";
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Sets, MistakesAreNamed) {
    const auto problem = [](const std::string& clauses) {
        Selecting s(with_cards(set_card("30", clauses)));
        s.nodes(30);
        return only(s.problems);
    };
    EXPECT_EQ(problem(clause("SOLID", {"1"})).value, "SOLID");
    EXPECT_EQ(problem(clause("NODE_Q", {"1"})).field, "KEY_type");
    EXPECT_EQ(problem(clause("", {"1"})).field, "KEY_type");
    EXPECT_EQ(problem(clause("NODE", {"77"})).value, "77");
    EXPECT_EQ(problem(clause("SET", {"77"})).field, "set_ID");
    EXPECT_EQ(problem(clause("NODE_G", {"5", "2"})).value, "5 2 1");
    EXPECT_EQ(problem(clause("MAT_G", {"1", "2"})).value, "MAT_G");
    EXPECT_NE(problem(clause("SET", {"30"})).rule.find("contain itself"), std::string::npos);
    Selecting twice(with_cards(set_card("3", clause("NODE", {"1"}))));
    twice.nodes(3);
    EXPECT_NE(only(twice.problems).rule.find("a /SET have this id"), std::string::npos);
}

TEST(Sets, DriveAWholeScene) {
    const std::string text =
        replaced(replaced(driven_scene(), "/GRNOD/PART/1\nblank\n" + ints({"1"}), set_card("1", clause("PART", {"1"}))),
                 "/SURF/PART/1\nblank\n" + ints({"1"}), "");
    const Resolved sets = resolved(text);
    const Resolved groups = resolved(driven_scene());
    EXPECT_TRUE(sets.problems.list().empty()) << all_of(sets.problems);
    EXPECT_EQ(sets.model.interfaces.at(0).secondary.node, groups.model.interfaces.at(0).secondary.node);
    EXPECT_EQ(sets.model.groups.at(1).nodes, groups.model.groups.at(1).nodes);
}

}  // namespace
}  // namespace type21
