#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/resolve.h"

namespace type21 {
namespace {

using namespace test;

TEST(Keywords, WhatChangesNothingIsSilentOrShared) {
    for (const char* card :
         {"/MEMORY\n         0                             0\n", "/CHECKSUM/START/a\nx\n/CHECKSUM/END\n",
          "/RANDOM\n                 0.0                 0.0\n", "/GRSHEL/PART/4\ng\n         1\n",
          "/BOX/RECTA/1\nb\n         0         0         0\n", "/LINE/SEG/1\nl\n", "/SURF/ELLIPS/9\ns\n",
          "/SENSOR/RBODY/9\ns\n", "/SKEW/MOV/9\ns\n", "/IOFLAG\n", "/SPMD\n"}) {
        const Resolved r = resolved(with_cards(card));
        EXPECT_TRUE(r.problems.list().empty()) << card << all_of(r.problems);
    }
}

TEST(Keywords, CardsOfOutputAndFormulationsShareOneWarning) {
    const Resolved r = resolved(with_cards("/SHFRA/V4\n/ACCEL/1\nacc\n       201\n/ATH/NODE/7\nn\nDEF\n       201\n"
                                           "/TH/SHEL/1\nt\nDEF\n/TH/SHEL/2\nt\nDEF\n/TH/PART/1\nt\n/SECT/1\nt\n"),
                                driven_engine() + "/ANIM/DT\n0 1\n/ANIM/VECT/VEL\n/H3D/DT\n0 1\n/ATFILE\n0.1\n");
    const Problem p = only(r.problems);
    EXPECT_EQ(p.severity, Severity::warning);
    EXPECT_EQ(p.value, "/ACCEL, /ANIM (2), /ATFILE, /ATH, /H3D, /SECT, /SHFRA, /TH/PART, /TH/SHEL (2)");
}

TEST(Keywords, RandomThatMovesNodesIsAnError) {
    const Problem p = only(resolved(with_cards("/RANDOM\n                0.01                 0.3\n")).problems);
    EXPECT_EQ(p.severity, Severity::error);
    EXPECT_EQ(p.value, "0.01 mm");
    EXPECT_FALSE(resolved(with_cards("/RANDOM/GRNOD/3\n                0.01\n")).problems.list().empty());
    EXPECT_FALSE(resolved(with_cards("/RANDOM\n                 NaN\n")).problems.list().empty());
}

TEST(Keywords, ElementCardsAreNotSupportedYet) {
    for (const char* card :
         {"/MAT/LAW36/9\nm\n", "/PROP/TYPE14/9\np\n", "/PLOAD/1\np\n", "/BRICK/1\n", "/FAIL/JOHNSON/1\n"})
        EXPECT_NE(only(resolved(with_cards(card)).problems).rule.find("not supported yet"), std::string::npos) << card;
}

TEST(Keywords, OtherPhysicsIsNamed) {
    for (const char* card : {"/RWALL/PLANE/1\nw\n", "/RBE2/1\nr\n", "/DAMP/1\nd\n", "/MPC/1\nm\n"})
        EXPECT_NE(only(resolved(with_cards(card)).problems).rule.find("may change the physics"), std::string::npos);
    EXPECT_NE(only(resolved(with_cards("/INTER/TYPE7/3\ni\n")).problems).rule.find("TYPE21"), std::string::npos);
    for (const char* card : {"/KEREL\n", "/DEL/SHELL/1\n", "/DT/AMS\n"})
        EXPECT_TRUE(resolved(driven_scene(), driven_engine() + card).problems.has_errors()) << card;
}

TEST(Keywords, WhatIsNotReadIsAnErrorWhereItIsUsed) {
    const Resolved r = resolved(with_cards("/SENSOR/RBODY/9\ns\n/CLOAD/1\nf\n" + ints({"1", "Z", "0", "9", "3"})));
    const Problem p = only(r.problems);
    EXPECT_EQ(p.card, "/SENSOR/RBODY/9");
    EXPECT_NE(p.rule.find("not supported"), std::string::npos) << p.rule;
}

TEST(Keywords, ADeckWithoutTheInterfaceSaysWhatItHas) {
    const TempFolder folder;
    const auto said = [&](const std::string& cards) {
        Problems problems;
        const Deck deck = read_deck(folder.write("x_0000.rad", "/BEGIN\n" + cards + "/END\n"), problems);
        check_interfaces(deck, Model(), problems);
        return problems.list().empty() ? std::string() : only(problems).rule;
    };
    EXPECT_NE(said("").find("no contact to compute"), std::string::npos);
    EXPECT_NE(said("/INTER/TYPE7/1\n/INTER/TYPE7/2\n/INTER/TYPE11/3\n").find("/INTER/TYPE11, /INTER/TYPE7 (2)"),
              std::string::npos);
    EXPECT_NE(said("/INTER/SUB/1\n").find("no contact to compute"), std::string::npos);
    EXPECT_EQ(said("/INTER/TYPE7/1\n/INTER/TYPE21/2\n"), "");
}

}  // namespace
}  // namespace type21
