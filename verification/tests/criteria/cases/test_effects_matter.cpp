// No case can pass with its effect off: the deck of a case is run once more with the field of the effect neutralised in
// its text, and the case's own criteria must then fail.
#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/host/prepare_deck.h"
#include "reference/model/interface_fields.h"
#include "verification/criteria/cases/evaluate.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

namespace fs = std::filesystem;

using test::read_text;
using test::TempFolder;
using test::write_text;

struct Edit {
    std::string_view field;
    std::string value;
};

/// One effect, the case that shows it, and what takes the effect away.
struct Row {
    Effect effect;
    std::string case_name, run;
    Id interface;
    std::vector<Edit> edits;
    bool stays_planned = false;  ///< the effect cannot be asked away, only made tiny
};

std::string name_of(const Row& row) {
    std::string name = row.case_name + "_" + std::to_string(row.interface);
    for (const Edit& edit : row.edits)
        name += "_" + std::string(edit.field);
    return name;
}

void PrintTo(const Row& row, std::ostream* out) {
    *out << name_of(row);
}

/// Each effect of the enum at least once, and each field whose absence another law takes the place of.
const std::vector<Row>& rows() {
    using enum Effect;
    static const std::vector<Row> table{
        {elastic, "turning_disc", "documented", 1, {{"Istf", "1"}, {"Stfac", "0"}}, true},
        {elastic, "stfac_0p3", "as_built", 1, {{"Stfac", "0"}}, true},
        {elastic, "stmin", "without_D01", 1, {{"Stmin", "0"}}, true},
        {elastic, "stmax", "without_D01", 1, {{"Stmax", "0"}}, true},
        {elastic, "depth", "as_built", 1, {{"DEPTH", "0"}}, true},
        {elastic, "igap1_parts", "as_built", 1, {{"Igap", "0"}}, true},
        {elastic, "igap2_fscale", "as_built", 1, {{"Fscalegap", "0"}}, true},
        {damping, "viss_0p2", "as_built", 1, {{"VISs", "1e-20"}}, true},
        {friction, "incline", "documented", 2, {{"Fric", "0"}}},
        {friction, "capstan", "documented", 1, {{"Fric", "0"}}},
        {friction, "sliding_to_rest", "documented", 1, {{"Fric", "0"}}},
        {friction, "turning_disc", "documented", 1, {{"Fric", "0"}}},
        {friction, "friction_laws_pv", "documented", 2, {{"Ifric", "0"}}, true},
        {friction, "friction_laws_pv", "documented", 3, {{"Ifric", "0"}}, true},
        {friction, "friction_laws_pv", "documented", 4, {{"Ifric", "0"}}},
        {friction, "friction_laws_pv", "documented", 5, {{"Ifric", "0"}}, true},
        {friction, "fric1_table", "as_built", 1, {{"fric_ID", "0"}}},
        {friction, "friction_pairs", "documented", 1, {{"fric_ID", "0"}}, true},
        {friction_filter, "filter_step", "documented", 2, {{"Ifiltr", "0"}}},
        {friction_filter, "filter_step", "documented", 3, {{"Ifiltr", "0"}}},
        {friction_filter, "filter_step", "documented", 4, {{"Ifiltr", "0"}}},
        {friction_heat_factor, "therm_fctidf", "without_D08", 1, {{"fct_IDF", "0"}}},
        {friction_heat_factor, "therm_fctidf", "without_D08", 1, {{"AscaleF", "1.0"}}, true},
        {gap_growth, "pmax_plateau", "documented", 1, {{"Igap", "1"}}},
        {gap_growth, "igap2_free", "as_built", 1, {{"Igap", "1"}}},
        {pmax_limit, "pmax_plateau", "documented", 1, {{"Pmax", "0"}}},
        {pmax_limit, "igap2_pmax_itlim0", "as_built", 1, {{"ITlim", "1"}}, true},
        {skid_line, "skid_line", "documented", 1, {{"Pskid", "0"}}},
        {heat, "cooling_node", "documented", 1, {{"Ithe", "0"}}},
        {heat, "cooling_node", "documented", 1, {{"Kthe", "0"}}, true},
        {heat, "heat_two_bodies", "documented", 1, {{"Ithe_form", "0"}}, true},
        {heat, "radiation_node", "documented", 1, {{"Frad", "0"}}, true},
        {heat, "therm_fheat", "as_built", 1, {{"Fheat", "0"}}, true},
        {heat, "therm_cond_pressure", "as_built", 1, {{"fct_IDK", "0"}}, true},
        {heat, "therm_rad_dist", "as_built", 1, {{"Fcond", "0"}}, true},
        {adaptive_data, "adaptive_data", "documented", 1, {{"Iadm", "0"}}},
        {adaptive_data, "adaptive_data", "documented", 2, {{"NRadm", "1"}}, true},
        {deletion, "idel", "documented", 1, {{"Idel", "0"}}},
        {deletion, "idel", "documented", 2, {{"Idel", "0"}}},
        {release_bcs, "ibc", "documented", 1, {{"IBC", "000"}}},
        {normals_test, "invn1_inverted", "documented", 1, {{"Invn", "0"}}},
        {tool_damping, "damped_press", "documented", 1, {{"Damp", "0"}}},
        {tool_damping, "tool_tilt_free", "as_built", 1, {{"Dampr", "0"}}, true},
        {tool_damping, "tool_drop_idref", "as_built", 1, {{"IDref", "0"}}, true},
        {initial_offset, "inacti_5", "as_built", 1, {{"Inacti", "0"}}},
        {initial_offset, "inacti_6", "as_built", 1, {{"Inacti", "5"}}, true},
        {activity_window, "tstart_tstop_hand", "documented", 2, {{"Tstart", "0"}}},
        {activity_window, "tstart_tstop_hand", "documented", 4, {{"Tstop", "0"}}},
        {activity_window, "tstart_tstop_hand", "documented", 5, {{"Tstart", "0"}}},
        {activity_window, "sensor_hand", "documented", 1, {{"sens_ID", "0"}}},
    };
    return table;
}

/// Writes a value, right-aligned, into the columns of a field of the card that begins after `title`.
void set_field(std::vector<std::string>& lines, Id interface, const Edit& edit) {
    const auto& fields = interface_fields();
    const auto field = std::find_if(fields.begin(), fields.end(), [&](const auto& f) { return f.name == edit.field; });
    ASSERT_NE(field, fields.end()) << edit.field;
    const std::string card = fmt::format("/INTER/TYPE21/{}", interface);
    auto line = std::find(lines.begin(), lines.end(), card);
    ASSERT_NE(line, lines.end()) << card;
    for (int data = -1; data < field->line;) {  // line 0 is the title
        ++line;
        ASSERT_NE(line, lines.end());
        if (!line->starts_with('#')) ++data;
    }
    const auto first = static_cast<size_t>(field->first - 1);
    const auto width = static_cast<size_t>(field->last - field->first + 1);
    line->resize(std::max(line->size(), first + width), ' ');
    line->replace(first, width, fmt::format("{:>{}}", edit.value, width));
}

std::vector<std::string> lines_of(const fs::path& path) {
    std::istringstream text(read_text(path));
    std::vector<std::string> lines;
    for (std::string line; std::getline(text, line);)
        lines.push_back(line);
    return lines;
}

/// The case's run with a deck of its own, in a folder where the engine deck lies beside it.
class SpoiltRun {
  public:
    SpoiltRun(const Case& a_case, const CaseRun& run, const Row& row) : run_(run) {
        for (const auto& file : fs::directory_iterator(a_case.folder))
            if (file.path().extension() == ".rad") fs::copy(file.path(), folder_ / file.path().filename().string());
        run_.deck = folder_ / run.deck.filename().string();
        std::vector<std::string> lines = lines_of(run_.deck);
        for (const Edit& edit : row.edits)
            set_field(lines, row.interface, edit);
        write_text(run_.deck, fmt::format("{}\n", fmt::join(lines, "\n")));
    }

    const CaseRun& run() const { return run_; }

  private:
    TempFolder folder_;
    CaseRun run_;
};

/// The criteria of the run that have a number or a message of their own; balances hold with any law.
struct Verdict {
    bool refused = false;
    int criteria = 0, failed = 0;
    std::string text;
};

Verdict verdict_of(const Case& a_case, size_t index, const CaseRun& run) {
    TempFolder folder;
    const CaseOutcome outcome = run_case(run, folder / "run", "reference");
    Verdict verdict;
    verdict.refused = outcome.refused;
    for (const std::string& problem : outcome.problems)
        verdict.text += problem + "\n";
    for (const Criterion& criterion : a_case.criteria) {
        if (criterion.run != index || std::holds_alternative<BalanceCriterion>(criterion.form)) continue;
        const CriterionResult result = evaluate(a_case, criterion, outcome);
        ++verdict.criteria;
        verdict.failed += result.ok ? 0 : 1;
        verdict.text += fmt::format("{}: {}\n", criterion.id, result.ok ? "holds" : "fails");
    }
    return verdict;
}

bool planned(const CaseRun& run, const Row& row) {
    const PreparedDeck deck = prepare_deck(run.deck.string(), run.as_built, true, run.thickness.string());
    if (!deck.scene) return false;
    const auto& interfaces = deck.scene->model->interfaces;
    for (size_t i = 0; i < interfaces.size(); ++i)
        if (interfaces[i].id == row.interface) return deck.scene->has(static_cast<int>(i), row.effect);
    return false;
}

class EffectsMatter : public testing::TestWithParam<Row> {};

TEST_P(EffectsMatter, TheCaseFailsWithoutTheEffect) {
    const Row& row = GetParam();
    std::vector<std::string> problems;
    const Case a_case = read_case(fs::path(TYPE21_SOURCE_DIR) / "cases" / row.case_name, problems);
    ASSERT_TRUE(problems.empty()) << problems.front();
    const auto run =
        std::find_if(a_case.runs.begin(), a_case.runs.end(), [&](const CaseRun& r) { return r.name == row.run; });
    ASSERT_NE(run, a_case.runs.end()) << row.run;
    const auto index = static_cast<size_t>(run - a_case.runs.begin());

    const Verdict with = verdict_of(a_case, index, *run);
    EXPECT_GT(with.criteria, 0);
    EXPECT_EQ(with.failed, 0) << with.text;
    EXPECT_TRUE(planned(*run, row));

    const SpoiltRun spoilt(a_case, *run, row);
    const Verdict without = verdict_of(a_case, index, spoilt.run());
    EXPECT_FALSE(without.refused) << "a refused deck shows nothing of the effect:\n" << without.text;
    EXPECT_GT(without.failed, 0) << "all criteria hold although the effect is off:\n" << without.text;
    EXPECT_EQ(planned(spoilt.run(), row), row.stays_planned);
}

INSTANTIATE_TEST_SUITE_P(Cases, EffectsMatter, testing::ValuesIn(rows()),
                         [](const auto& row) { return name_of(row.param); });

TEST(EffectsMatter, EveryEffectHasARow) {
    std::set<Effect> covered;
    for (const Row& row : rows())
        covered.insert(row.effect);
    for (int rank = 0; rank <= static_cast<int>(Effect::activity_window); ++rank)
        EXPECT_TRUE(covered.contains(static_cast<Effect>(rank))) << name(static_cast<Effect>(rank));
}

}  // namespace
}  // namespace type21
