#include <gtest/gtest.h>

#include "verification/criteria/cases/evaluate.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;
using test::write_text;

/// A case with one run that has completed, and its result folder.
struct Scenario {
    TempFolder measured, ours;
    Case a_case;
    CaseOutcome outcome;

    Scenario() {
        write_text(measured / "interface_1.csv", "time,FNX\n0,0\n1,4\n");
        write_text(ours / "interface_1.csv", "time,FNX\n0,0\n1,5\n");
        a_case.name = "case";
        a_case.folder = measured.path();
        a_case.runs.push_back({"run", "", "", ""});
        outcome.folder = ours.path();
        outcome.summary.state = RunSummary::State::completed;
        outcome.interfaces = {1, 2};
        outcome.summary.balance.resize(2);
        outcome.summary.balance[0].cycles_in_contact = 3;
        outcome.summary.balance[0].power = {1e-3, 2, 2.0};
        outcome.summary.balance[1].cycles_in_contact = 3;
        outcome.summary.balance[1].power = {1e-6, 1, 1.0};
    }

    template <class Form>
    CriterionResult check(Form form, double tolerance) {
        Criterion criterion;
        criterion.id = "id";
        criterion.tolerance = tolerance;
        criterion.form = std::move(form);
        a_case.criteria = {criterion};
        return evaluate(a_case, a_case.criteria[0], outcome);
    }
};

HistoryCriterion history_criterion(double tolerance) {
    HistoryCriterion form;
    form.rule.reference = form.rule.ours = "interface_1.csv";
    form.rule.options.tolerance = tolerance;
    return form;
}

TEST(Evaluate, AWholeHistory) {
    Scenario s;
    EXPECT_TRUE(s.check(history_criterion(0.25), 0.25).ok);
    const CriterionResult failed = s.check(history_criterion(0.24), 0.24);
    EXPECT_FALSE(failed.ok);
    EXPECT_EQ(failed.difference, 0.25);
    EXPECT_NE(failed.detail.find("FNX at t = 1"), std::string::npos);
    std::filesystem::remove(s.ours / "interface_1.csv");
    EXPECT_FALSE(s.check(history_criterion(1), 1).ok);
}

TEST(Evaluate, OneValueRelativeAndAbsolute) {
    Scenario s;
    ValueCriterion form{"interface_1.csv", "FNX", {}, {}, 4, false};
    EXPECT_TRUE(s.check(form, 0.25).ok);
    EXPECT_FALSE(s.check(form, 0.2).ok);
    form.absolute = true;
    EXPECT_TRUE(s.check(form, 1).ok);
    EXPECT_FALSE(s.check(form, 0.9).ok);
    form.column = "FNY";
    EXPECT_FALSE(s.check(form, 1e9).ok);
    EXPECT_NE(s.check(form, 1e9).detail.find("no column FNY"), std::string::npos);
}

TEST(Evaluate, ADepartureSwitchedOff) {
    Scenario s;
    DepartureCriterion form{"interface_1.csv", "interface_1.csv", "FNX", {}, {}, 1.0, false};
    EXPECT_TRUE(s.check(form, 0).ok);
    form.by = -1;
    EXPECT_FALSE(s.check(form, 0.5).ok);
    // A departure without any effect does not pass.
    write_text(s.ours / "interface_1.csv", "time,FNX\n0,0\n1,4\n");
    form.by = 1;
    EXPECT_FALSE(s.check(form, 0.5).ok);
}

TEST(Evaluate, TheBalanceOfAllInterfacesOrOfOne) {
    Scenario s;
    EXPECT_TRUE(s.check(BalanceCriterion{"power", {}}, 1e-3).ok);
    EXPECT_FALSE(s.check(BalanceCriterion{"power", {}}, 1e-4).ok);
    EXPECT_TRUE(s.check(BalanceCriterion{"power", 2}, 1e-6).ok);
    EXPECT_TRUE(s.check(BalanceCriterion{"force", {}}, 0).ok);
    EXPECT_FALSE(s.check(BalanceCriterion{"power", 3}, 1).ok);
    for (InterfaceBalance& balance : s.outcome.summary.balance)
        balance.cycles_in_contact = 0;
    EXPECT_FALSE(s.check(BalanceCriterion{"force", {}}, 1).ok);
}

TEST(Evaluate, ARefusedDeckFailsAllButTheCheckThatExpectsIt) {
    Scenario s;
    EXPECT_FALSE(s.check(RefusalCriterion{"DEPTH"}, 0).ok);  // accepted
    s.outcome.refused = true;
    s.outcome.problems = {"a.rad:3: error: other", "a.rad:5: error: field 'DEPTH' = -1 mm"};
    EXPECT_TRUE(s.check(RefusalCriterion{"'DEPTH' = -1"}, 0).ok);
    EXPECT_FALSE(s.check(RefusalCriterion{"Gapmin"}, 0).ok);
    EXPECT_FALSE(s.check(history_criterion(1e9), 1e9).ok);
    EXPECT_FALSE(s.check(BalanceCriterion{"force", {}}, 1).ok);
    EXPECT_FALSE(s.check(StopCriterion{""}, 0).ok);
}

TEST(Evaluate, AStoppedRunFailsUnlessItIsExpected) {
    Scenario s;
    EXPECT_FALSE(s.check(StopCriterion{"node 7"}, 0).ok);  // completed
    s.outcome.summary.state = RunSummary::State::stopped;
    s.outcome.summary.reason = "Invn: node 7";
    EXPECT_TRUE(s.check(StopCriterion{"node 7"}, 0).ok);
    EXPECT_FALSE(s.check(StopCriterion{"node 8"}, 0).ok);
    EXPECT_FALSE(s.check(history_criterion(1), 1).ok);

    Criterion stop, history;
    stop.form = StopCriterion{"node 7"};
    history.form = history_criterion(1);
    history.tolerance = 1;
    s.a_case.criteria = {stop, history};
    EXPECT_TRUE(evaluate(s.a_case, s.a_case.criteria[1], s.outcome).ok);
}

TEST(Evaluate, AnInternalErrorFailsEverything) {
    Scenario s;
    s.outcome.error = "disk full";
    EXPECT_FALSE(s.check(history_criterion(1e9), 1e9).ok);
    EXPECT_FALSE(s.check(RefusalCriterion{""}, 0).ok);
    EXPECT_EQ(s.check(StopCriterion{""}, 0).detail, "disk full");
}

}  // namespace
}  // namespace type21
