// Each departure that can be switched has a case with both numbers: two runs of one deck that differ in that departure
// only, and the criteria of the one fail on the results of the other.
#include <filesystem>
#include <map>
#include <optional>

#include <gtest/gtest.h>

#include "reference/contract/departures.h"
#include "reference/model/as_built_option.h"
#include "verification/criteria/cases/evaluate.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;

AsBuilt parsed(const std::string& text) {
    Problems problems;
    return parse_as_built(text, problems);
}

/// The one departure in which two runs of the same deck differ.
std::optional<Departure> only_difference(const CaseRun& one, const CaseRun& other) {
    if (one.deck != other.deck || one.thickness != other.thickness) return {};
    const AsBuilt a = parsed(one.as_built);
    const AsBuilt b = parsed(other.as_built);
    std::optional<Departure> difference;
    for (const DepartureRow& row : departures()) {
        if (a.has(row.id) == b.has(row.id)) continue;
        if (difference) return {};
        difference = row.id;
    }
    return difference;
}

/// Whether a criterion of run `index` with a value of its own fails when the run has the departures of another.
bool tells_apart(const Case& a_case, size_t index, const CaseRun& other) {
    CaseRun changed = a_case.runs[index];
    changed.as_built = other.as_built;
    TempFolder folder;
    const CaseOutcome outcome = run_case(changed, folder / "run", "reference");
    for (const Criterion& criterion : a_case.criteria) {
        if (criterion.run != index || std::holds_alternative<BalanceCriterion>(criterion.form)) continue;
        if (!evaluate(a_case, criterion, outcome).ok) return true;
    }
    return false;
}

/// Departures that no case shows, and the unit test that does.
const std::map<Departure, std::string>& shown_by_a_test() {
    static const std::map<Departure, std::string> table{
        {Departure::D15, "Heat.Zones: the nearest distance limits the search to Drad, so a run hardly shows it"},
        {Departure::D35, "Projection: a nodal normal that leans more than 90 degrees"},
    };
    return table;
}

TEST(DeparturesMatter, EachHasACaseWithBothNumbers) {
    std::vector<std::string> problems;
    const std::vector<Case> cases = read_cases(std::filesystem::path(TYPE21_SOURCE_DIR) / "cases", {}, problems);
    ASSERT_TRUE(problems.empty()) << problems.front();
    std::map<Departure, int> shown;
    for (const Case& a_case : cases) {
        for (size_t i = 0; i < a_case.runs.size(); ++i) {
            for (size_t j = 0; j < a_case.runs.size(); ++j) {
                const auto difference = only_difference(a_case.runs[i], a_case.runs[j]);
                if (!difference) continue;
                EXPECT_TRUE(tells_apart(a_case, i, a_case.runs[j]))
                    << a_case.name << ": the criteria of run " << a_case.runs[i].name << " hold for run "
                    << a_case.runs[j].name << ", too";
                if (i < j) ++shown[*difference];
            }
        }
    }
    for (const DepartureRow& row : departures()) {
        if (!row.available) continue;
        EXPECT_NE(shown.contains(row.id), shown_by_a_test().contains(row.id))
            << name(row.id) << " has neither a case nor an entry here, or both";
    }
}

}  // namespace
}  // namespace type21
