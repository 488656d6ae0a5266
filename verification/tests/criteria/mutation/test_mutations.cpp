// The mutations themselves: what a mutation does not change turns nothing red, and some that must be seen are.
#include <set>

#include <gtest/gtest.h>

#include "verification/criteria/cases/verify_cases.h"
#include "verification/criteria/mutation/break_contact.h"
#include "verification/criteria/mutation/score.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

namespace fs = std::filesystem;

std::vector<MutationVerdict> judged(const std::vector<Mutation>& some, const std::vector<std::string>& names) {
    const fs::path root = fs::path(TYPE21_SOURCE_DIR) / "cases";
    std::vector<std::string> problems;
    const std::vector<Case> cases = read_cases(root, names, problems);
    EXPECT_TRUE(problems.empty());
    test::TempFolder folder;
    ScoreOptions options;
    options.decisions = root / "decisions";
    options.scratch = folder.path();
    options.jobs = 2;
    return score(some, cases, options);
}

std::vector<Mutation> named(const std::set<std::string>& names) {
    std::vector<Mutation> some;
    for (const Mutation& mutation : mutations())
        if (names.contains(mutation.name)) some.push_back(mutation);
    EXPECT_EQ(some.size(), names.size());
    return some;
}

const std::vector<std::string> short_cases{"depth",     "fric0_card",      "filter3_high", "pmax_plateau",
                                           "therm_rad", "tool_drop_idref", "igap1_parts",  "skid_line"};

/// Were a decorator itself to turn a check red, the score would say nothing.
TEST(MutationControl, WhatChangesNothingTurnsNothingRed) {
    const auto always = has_effect(Effect::elastic);
    const std::vector<Mutation> nothing{
        {"card", "none", "nothing", always, broken_card([](ContactModel&, Interface&) {}), {}},
        {"motion", "none", "nothing", always, broken_motion([](Motion&, const Interface&) {}), {}},
        {"sums", "none", "nothing", always, broken_sums([](ContactStep&) {}), {}},
        {"nodes", "none", "nothing, but summed again", always, broken_nodes([](NodeContact&) {}), {}},
    };
    for (const MutationVerdict& verdict : judged(nothing, short_cases)) {
        EXPECT_FALSE(verdict.red) << verdict.mutation.name << " in " << verdict.case_name << ": " << verdict.criterion;
        EXPECT_TRUE(verdict.detail.empty()) << verdict.detail;
        EXPECT_GT(verdict.tried, 10);
    }
}

TEST(Mutations, AFewAreSeen) {
    const auto verdicts =
        judged(named({"gap_one_ulp", "low_border_one_ulp", "tie_reversed", "candidate_dropped", "friction_off",
                      "stiffness_millionth", "friction_reversed", "pmax_infinite", "filter_3_off", "radiation_off",
                      "idref_ignored", "skid_envelope_forgotten", "node_dropped", "gaps_equal"}),
               short_cases);
    for (const MutationVerdict& verdict : verdicts)
        EXPECT_TRUE(verdict.red) << verdict.mutation.name << " survives " << verdict.tried;
}

TEST(Mutations, HaveNamesOfTheirOwnAndSayWhatTheyBreak) {
    std::set<std::string> names;
    for (const Mutation& mutation : mutations()) {
        EXPECT_TRUE(names.insert(mutation.name).second) << mutation.name << " is there twice";
        EXPECT_FALSE(mutation.effect.empty()) << mutation.name;
        EXPECT_FALSE(mutation.broken.empty()) << mutation.name;
        EXPECT_NE(mutation.contact == nullptr, mutation.decision == nullptr) << mutation.name;
        EXPECT_EQ(mutation.contact == nullptr, mutation.concerns == nullptr) << mutation.name;
    }
}

/// A mutation that nothing sees is named, and the score says so.
TEST(Mutations, ASurvivorIsNamed) {
    const std::vector<Mutation> nothing{
        {"harmless", "none", "nothing", has_effect(Effect::elastic), broken_sums([](ContactStep&) {}), {}}};
    const auto verdicts = judged(nothing, {"depth"});
    EXPECT_NE(to_text(verdicts).find("SURVIVES"), std::string::npos);
    EXPECT_EQ(to_json(verdicts)["killed"], 0);
    EXPECT_EQ(to_json(verdicts)["all"], 1);
}

}  // namespace
}  // namespace type21
