#include "verification/criteria/cases/evaluate.h"

#include <algorithm>
#include <cmath>
#include <regex>

#include <fmt/format.h>

#include "verification/criteria/cases/value_at.h"
#include "verification/results/balance/balance.h"

namespace type21 {
namespace {

void set_expected(CheckResult& result, double value) {
    result.expected = fmt::format("{:.10g}", value);
    result.expected_number = value;
}

void set_got(CheckResult& result, double value) {
    result.got = fmt::format("{:.10g}", value);
    if (std::isfinite(value)) result.got_number = value;
}

void set_texts(CheckResult& result, const std::string& expected, const std::string& got) {
    result.expected = expected;
    result.got = got;
}

/// A NaN fails: every comparison with it is false.
void judge(CheckResult& result, double difference) {
    result.difference = difference;
    result.ok = difference <= result.tolerance;
}

void judge_value(CheckResult& result, double got, double expected, bool absolute) {
    set_expected(result, expected);
    set_got(result, got);
    judge(result, std::abs(got - expected) / (absolute ? 1.0 : std::abs(expected)));
}

class Evaluation {
  public:
    Evaluation(const Case& a_case, const CaseOutcome& outcome, CheckResult& result)
        : case_(a_case), outcome_(outcome), result_(result) {}

    void operator()(const HistoryCheck& form) {
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

    void operator()(const ValueCheck& form) {
        const double got = value_at(read_csv(outcome_.folder / form.file), form.column, form.at, form.object);
        judge_value(result_, got, form.expected, form.absolute);
        result_.detail = fmt::format("{} of {}", form.column, form.file);
    }

    void operator()(const DepartureCheck& form) {
        const double ours = value_at(read_csv(outcome_.folder / form.file), form.column, form.at, form.object);
        const double measured = value_at(read_csv(case_.folder / form.reference), form.column, form.at, form.object);
        judge_value(result_, ours - measured, form.by, form.absolute);
        result_.detail = fmt::format("ours {:.10g}, measured {:.10g}", ours, measured);
    }

    void operator()(const BalanceCheck& form) {
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
        if (cycles == 0) throw NoValue("no node was ever in contact: nothing was balanced");
        set_got(result_, worst);
        judge(result_, worst);
    }

    void operator()(const RefusalCheck& form) {
        const std::regex pattern(form.message);
        const auto found = std::find_if(outcome_.problems.begin(), outcome_.problems.end(),
                                        [&](const std::string& text) { return std::regex_search(text, pattern); });
        const bool matched = found != outcome_.problems.end();
        set_texts(result_, "exit 2: " + form.message,
                  outcome_.refused ? (matched ? *found : "other problems") : "deck accepted");
        result_.ok = outcome_.refused && matched;
        if (!result_.ok && !outcome_.problems.empty()) result_.detail = outcome_.problems.front();
    }

    void operator()(const StopCheck& form) {
        const bool stopped = outcome_.summary.state == RunSummary::State::stopped ||
                             outcome_.summary.state == RunSummary::State::diverged;
        set_texts(result_, "stop: " + form.message, stopped ? outcome_.summary.reason : "run completed");
        result_.ok = stopped && std::regex_search(outcome_.summary.reason, std::regex(form.message));
    }

  private:
    const Case& case_;
    const CaseOutcome& outcome_;
    CheckResult& result_;
};

bool expects_stop(const Case& a_case, size_t run) {
    return std::any_of(a_case.checks.begin(), a_case.checks.end(), [&](const CaseCheck& check) {
        return check.run == run && std::holds_alternative<StopCheck>(check.form);
    });
}

/// Why no check of this run can hold; empty when there is no such reason.
std::string run_failure(const Case& a_case, const CaseCheck& check, const CaseOutcome& outcome) {
    if (!outcome.error.empty()) return outcome.error;
    if (std::holds_alternative<RefusalCheck>(check.form)) return "";
    if (outcome.refused)
        return "the deck is refused: " +
               (outcome.problems.empty() ? std::string("no message") : outcome.problems.front());
    if (outcome.summary.state != RunSummary::State::completed && !expects_stop(a_case, check.run))
        return fmt::format("the run {}: {}", name(outcome.summary.state), outcome.summary.reason);
    return "";
}

}  // namespace

CheckResult evaluate(const Case& a_case, const CaseCheck& check, const CaseOutcome& outcome) {
    CheckResult result;
    result.id = check.id;
    result.case_name = a_case.name;
    result.run = a_case.runs[check.run].name;
    result.kind = name(check.kind);
    result.equation = check.equation;
    result.tolerance = check.tolerance;
    result.unit = check.unit;
    result.reason = check.reason;
    result.seconds = outcome.seconds;
    try {
        result.detail = run_failure(a_case, check, outcome);
        if (result.detail.empty()) std::visit(Evaluation(a_case, outcome, result), check.form);
    } catch (const std::exception& error) {
        result.ok = false;
        result.detail = error.what();
    }
    return result;
}

}  // namespace type21
