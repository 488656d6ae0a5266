#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::DeckCopy;
using test::Outcome;
using test::TempFolder;

TEST(Check, PrintsFieldsUnitsAndEffects) {
    TempFolder folder;
    const auto deck = test::cases() / "cylinder_slide/cylinder_slide_0000.rad";
    const Outcome outcome =
        test::type21("check " + test::in_quotes(deck) + " --json " + test::in_quotes(folder / "deep/check.json"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    for (const char* text :
         {"Mg mm s", "Gapmin", "0.15", "Coulomb friction", "N/mm", "DEPTH", "rigid tool", "line 489", "45 nodes"})
        EXPECT_NE(outcome.out.find(text), std::string::npos) << text;

    const auto json = nlohmann::json::parse(test::read_text(folder / "deep/check.json"));
    EXPECT_EQ(json["valid"], true);
    EXPECT_EQ(json["interfaces"][0]["main"]["segments"], 144);
    EXPECT_EQ(json["interfaces"][0]["time_zero"]["stiffness"]["largest"], 252000.0);
    const auto& penetrations = json["interfaces"][0]["time_zero"]["initial_penetrations"];
    ASSERT_EQ(penetrations.size(), 45U);
    EXPECT_GE(penetrations[0]["penetration"], penetrations[44]["penetration"]);
    // Twenty on the screen, all in the file.
    EXPECT_NE(outcome.out.find("and 25 more"), std::string::npos);
}

TEST(Check, GivesNodesAndSegmentsWhenAsked) {
    TempFolder folder;
    const auto deck = test::cases() / "cylinder_slide/cylinder_slide_0000.rad";
    const std::string command = "check " + test::in_quotes(deck) + " --geometry";
    EXPECT_EQ(test::type21(command).code, 1) << "--geometry without --json";
    ASSERT_EQ(test::type21(command + " --json " + test::in_quotes(folder / "check.json")).code, 0);
    const auto json = nlohmann::json::parse(test::read_text(folder / "check.json"))["geometry"];
    // Node 20001 as the deck has it; 144 tool quads, 32 of the blank.
    const auto& nodes = json["nodes"];
    ASSERT_EQ(nodes.size(), 217U);
    const auto node = std::find_if(nodes.begin(), nodes.end(), [](const auto& row) { return row[0] == 20001; });
    ASSERT_NE(node, nodes.end());
    EXPECT_EQ(*node, nlohmann::json({20001, -15.666538192549668, -8.0, 7.567800634586712}));
    const auto& sides = json["interfaces"][0];
    EXPECT_EQ(sides["main"].size(), 144U);
    EXPECT_EQ(sides["secondary"].size(), 32U);
    EXPECT_EQ(sides["secondary"][0].size(), 4U);
}

TEST(Check, NeedsNoEngineDeck) {
    const DeckCopy deck("flat_press");
    std::filesystem::remove(deck.engine);
    EXPECT_EQ(test::type21("check " + test::in_quotes(deck.starter)).code, 0);
}

TEST(Check, SaysAllProblemsAndExitsTwo) {
    const DeckCopy deck("flat_press");
    deck.replace(deck.starter, "/SURF/PART/1\n", "/SURF/PART/17\n");
    deck.replace(deck.starter, "/IMPVEL/101", "/NOSUCHCARD/101");
    TempFolder folder;
    const Outcome outcome =
        test::type21("check " + test::in_quotes(deck.starter) + " --json " + test::in_quotes(folder / "c.json"));
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("NOSUCHCARD"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("surf_IDs"), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("2 errors"), std::string::npos) << outcome.err;
    const auto json = nlohmann::json::parse(test::read_text(folder / "c.json"));
    EXPECT_EQ(json["valid"], false);
    EXPECT_GE(json["problems"].size(), 2U);
}

TEST(Check, AnUnreadableFileIsADeckError) {
    TempFolder folder;
    for (const std::filesystem::path& path : {folder / "nothing_0000.rad", folder.path()}) {
        const Outcome outcome = test::type21("check " + test::in_quotes(path));
        EXPECT_EQ(outcome.code, 2) << path;
        EXPECT_NE(outcome.err.find("error"), std::string::npos);
    }
    test::write_text(folder / "noise_0000.rad", std::string("\x7f\x45\x4c\x46\0\1\2\xff", 8));
    EXPECT_EQ(test::type21("check " + test::in_quotes(folder / "noise_0000.rad")).code, 2);
}

/// One judgement for both: a free blank, a moment on single nodes.
TEST(Check, RefusesWhatARunWouldRefuse) {
    const std::pair<std::string, std::string> changes[] = {
        {"   111 111         0         1\n", "   110 111         0         1\n"},
        {"/BCS/1\n", "/CLOAD/1\nmoment\n         1        XX         0         0         1\n/BCS/1\n"}};
    for (const auto& [from, to] : changes) {
        const DeckCopy deck("flat_press");
        deck.replace(deck.starter, from, to);
        const Outcome check = test::type21("check " + test::in_quotes(deck.starter));
        const Outcome run =
            test::type21("run " + test::in_quotes(deck.starter) + " --out " + test::in_quotes(deck.out()));
        EXPECT_EQ(check.code, 2) << to << check.err;
        EXPECT_EQ(run.code, 2) << to << run.err;
        EXPECT_EQ(check.err, run.err) << to;
    }
}

TEST(Check, NothingOfADeckSteersTheTerminal) {
    const DeckCopy deck("flat_press");
    deck.replace(deck.starter, "/TITLE\n", "/TITLE\n\x1b]0;x\x07\x1b[2J\x1b[31m");
    const Outcome outcome = test::type21("check " + test::in_quotes(deck.starter));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ((outcome.out + outcome.err).find('\x1b'), std::string::npos);
    EXPECT_NE(outcome.out.find("\\x1b[31m"), std::string::npos);
}

TEST(Check, AReportThatCannotBeWrittenIsAUsageError) {
    const auto deck = test::cases() / "flat_press/flat_press_0000.rad";
    EXPECT_EQ(test::type21("check " + test::in_quotes(deck) + " --json /proc/no/such.json").code, 1);
}

}  // namespace
}  // namespace type21
