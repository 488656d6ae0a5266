#include "verification/criteria/cases/evaluate.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "verification/criteria/cases/value_at.h"
#include "verification/results/balance/balance.h"

namespace type21 {
namespace {

void set_expected(CriterionResult& result, double value) {
    result.expected = fmt::format("{:.10g}", value);
    result.expected_number = value;
}

void set_got(CriterionResult& result, double value) {
    result.got = fmt::format("{:.10g}", value);
    if (std::isfinite(value)) result.got_number = value;
}

void set_texts(CriterionResult& result, const std::string& expected, const std::string& got) {
    result.expected = expected;
    result.got = got;
}

/// A NaN fails: every comparison with it is false.
void judge(CriterionResult& result, double difference) {
    result.difference = difference;
    result.ok = difference <= result.tolerance;
}

void judge_value(CriterionResult& result, double got, double expected, bool absolute) {
    set_expected(result, expected);
    set_got(result, got);
    judge(result, std::abs(got - expected) / (absolute ? 1.0 : std::abs(expected)));
}

class Evaluation {
  public:
    Evaluation(const Case& a_case, const CaseOutcome& outcome, CriterionResult& result)
        : case_(a_case), outcome_(outcome), result_(result) {}

    void operator()(const HistoryCriterion& form) {
        const TableResult table = compare_tables(read_csv(outcome_.folder / form.rule.ours),
                                                 read_csv(case_.folder / form.rule.reference), form.rule.options);
        result_.expected = form.rule.reference;
        result_.unit = "of the column's scale";
        result_.columns = table.columns;
        if (const ColumnResult* worst = table.worst()) {
            set_got(result_, worst->scaled);
            judge(result_, worst->scaled);
            result_.detail = fmt::format("{} at t = {:.6g}", worst->column, worst->time);
            if (worst->object) result_.detail += fmt::format(", node {}", *worst->object);
        }
        for (const std::string& note : table.notes)
            result_.detail += "; " + note;
        for (const std::string& mismatch : table.mismatches)
            result_.detail += "; " + mismatch;
        result_.ok = table.ok();
    }

    void operator()(const ValueCriterion& form) {
        const double got = value_at(read_csv(outcome_.folder / form.file), form.column, form.at, form.object);
        judge_value(result_, got, form.expected, form.absolute);
        result_.detail = fmt::format("{} of {}", form.column, form.file);
    }

    void operator()(const DepartureCriterion& form) {
        const double ours = value_at(read_csv(outcome_.folder / form.file), form.column, form.at, form.object);
        const double measured = value_at(read_csv(case_.folder / form.reference), form.column, form.at, form.object);
        judge_value(result_, ours - measured, form.by, form.absolute);
        result_.detail = fmt::format("ours {:.10g}, measured {:.10g}", ours, measured);
    }

    void operator()(const BalanceCriterion& form) {
        result_.expected = "0";
        result_.expected_number = 0;
        result_.unit = "of the sum of absolute terms";
        double worst = 0;
        long cycles = 0;
        bool found = false;
        for (size_t i = 0; i < outcome_.summary.balance.size(); ++i) {
            if (form.interface && outcome_.interfaces[i] != *form.interface) continue;
            found = true;
            const InterfaceBalance& balance = outcome_.summary.balance[i];
            const Residual& residual = *find_residual(balance, form.quantity);
            cycles += balance.cycles_in_contact;
            if (residual.relative < worst) continue;
            worst = residual.relative;
            result_.detail = fmt::format("interface {}, cycle {}", outcome_.interfaces[i], residual.cycle);
        }
        if (!found) throw NoValue("the deck has no such interface");
        if (cycles == 0) throw NoValue("no node was in contact in any cycle: there is nothing to balance");
        set_got(result_, worst);
        judge(result_, worst);
    }

    void operator()(const RefusalCriterion& form) {
        const std::regex pattern(form.message);
        const auto found = std::find_if(outcome_.problems.begin(), outcome_.problems.end(),
                                        [&](const std::string& text) { return std::regex_search(text, pattern); });
        const bool matched = found != outcome_.problems.end();
        set_texts(result_, "exit 2: " + form.message,
                  outcome_.refused ? (matched ? *found : "other problems") : "deck accepted");
        result_.ok = outcome_.refused && matched;
        if (!result_.ok && !outcome_.problems.empty()) result_.detail = outcome_.problems.front();
    }

    void operator()(const StopCriterion& form) {
        const bool stopped = outcome_.summary.state == RunSummary::State::stopped ||
                             outcome_.summary.state == RunSummary::State::diverged;
        set_texts(result_, "stop: " + form.message, stopped ? outcome_.summary.reason : "run completed");
        result_.ok = stopped && std::regex_search(outcome_.summary.reason, std::regex(form.message));
    }

  private:
    const Case& case_;
    const CaseOutcome& outcome_;
    CriterionResult& result_;
};

bool expects_stop(const Case& a_case, size_t run) {
    return std::any_of(a_case.criteria.begin(), a_case.criteria.end(), [&](const Criterion& criterion) {
        return criterion.run == run && std::holds_alternative<StopCriterion>(criterion.form);
    });
}

/// Why no criterion of this run can hold; empty if they can.
std::string run_failure(const Case& a_case, const Criterion& criterion, const CaseOutcome& outcome) {
    if (!outcome.error.empty()) return outcome.error;
    if (std::holds_alternative<RefusalCriterion>(criterion.form)) return "";
    if (outcome.refused)
        return "the deck is refused: " +
               (outcome.problems.empty() ? std::string("no message") : outcome.problems.front());
    if (outcome.summary.state != RunSummary::State::completed && !expects_stop(a_case, criterion.run))
        return fmt::format("the run {}: {}", name(outcome.summary.state), outcome.summary.reason);
    return "";
}

}  // namespace

CriterionResult evaluate(const Case& a_case, const Criterion& criterion, const CaseOutcome& outcome) {
    CriterionResult result;
    result.id = criterion.id;
    result.case_name = a_case.name;
    result.run = a_case.runs[criterion.run].name;
    result.kind = name(criterion.kind);
    result.equation = criterion.equation;
    result.tolerance = criterion.tolerance;
    result.unit = criterion.unit;
    result.reason = criterion.reason;
    result.seconds = outcome.seconds;
    try {
        result.detail = run_failure(a_case, criterion, outcome);
        if (result.detail.empty()) std::visit(Evaluation(a_case, outcome, result), criterion.form);
    } catch (const std::exception& error) {
        result.ok = false;
        result.detail = error.what();
    }
    return result;
}

}  // namespace type21
