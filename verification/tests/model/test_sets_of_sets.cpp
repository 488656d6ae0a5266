#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

std::string chain(const std::string& keyword, int first, int count, int end) {
    std::string cards;
    for (int i = 0; i < count; ++i)
        cards += fmt::format("{}/{}\nlink\n{:>10}\n", keyword, first + i, i + 1 < count ? first + i + 1 : end);
    return cards;
}

/// A card that uses this group: what nothing uses is not read.
std::string use(int group) {
    return fmt::format("/ADMAS/0/{}\nmass\n{:>20}{:>10}\n", group, "1.0", group);
}

size_t nodes_of(const Resolved& r, Id group) {
    for (const NodeGroup& g : r.model.groups)
        if (g.id == group) return g.nodes.size();
    return 0;
}

TEST(SetsOfSets, ALongChainFromItsWrongEndIsMade) {
    const Resolved r = resolved(with_cards(chain("/GRNOD/GRNOD", 100, 20000, 2) + chain("/SURF/SURF", 100, 20000, 2) +
                                           "/GRNOD/SURF/90000\ns\n" + ints({"100"}) + use(100) + use(90000)));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(nodes_of(r, 100), 4U);
    EXPECT_EQ(nodes_of(r, 90000), 4U);
    EXPECT_EQ(nodes_of(r, 20099), 0U) << "no card names the links, so that they hold no memory";
}

TEST(SetsOfSets, ALongCycleIsAnError) {
    const std::string cycle = chain("/GRNOD/GRNOD", 100, 5000, 100);
    EXPECT_NE(only(resolved(with_cards(cycle + use(100))).problems).rule.find("contain itself"), std::string::npos);
    EXPECT_TRUE(resolved(with_cards(cycle)).problems.list().empty()) << "nothing uses it";
}

TEST(SetsOfSets, SetsThatDoubleAtEveryLinkEnd) {
    std::string cards;
    for (int i = 0; i < 60; ++i) {
        const std::string next = i + 1 < 60 ? fmt::format("{}", 101 + i) : "2";
        cards += fmt::format("/SURF/SURF/{}\nlink\n", 100 + i) + ints({next, next});
    }
    const Resolved r = resolved(with_cards(cards + "/GRNOD/SURF/90000\ns\n" + ints({"100"}) + use(90000)));
    EXPECT_NE(only(r.problems).rule.find("at most"), std::string::npos) << all_of(r.problems);
}

TEST(SetsOfSets, OneSetOfManyListsEachNodeOnce) {
    std::string cards = "/GRNOD/GRNOD/50\nall\n";
    for (int i = 0; i < 500; ++i)
        cards += ints({"1", "2", "3", "1", "2", "3", "1", "2", "3", "1"});
    const Resolved r = resolved(with_cards(cards + use(50)));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(nodes_of(r, 50), 10U);
}

TEST(SetsOfSets, AnEmptyGroupIsAnErrorWhereACardUsesIt) {
    const std::string empty = "/GRNOD/NODE/50\nnobody\n/GRNOD/GRNOD/51\nnobody either\n" + ints({"50"});
    EXPECT_TRUE(resolved(with_cards(empty)).problems.list().empty()) << "nothing refers to them";
    for (const char* id : {"50", "51"}) {
        for (const std::string& card :
             {"/CLOAD/1\nf\n" + ints({"1", "Z", "0", "0", id}), "/BCS/9\nb\n   111 111" + ints({"0", id}),
              "/IMPVEL/9\nv\n" + ints({"1", "X", "0", "0", id}) + "\n"}) {
            const Problem p = only(resolved(with_cards(empty + card)).problems);
            EXPECT_EQ(p.severity, Severity::error);
            EXPECT_EQ(p.value, id);
            EXPECT_NE(p.rule.find("is empty"), std::string::npos) << p.rule;
        }
    }
    const std::string surface = "/SURF/SEG/50\nnothing\n/GRNOD/SURF/51\nof nothing\n" + ints({"50"}) + use(51);
    EXPECT_NE(only(resolved(with_cards(surface)).problems).rule.find("/GRNOD is empty"), std::string::npos);
}

}  // namespace
}  // namespace type21
