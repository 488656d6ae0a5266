#include "verification/criteria/cases/case_file.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include "reference/contract/departures.h"
#include "reference/model/as_built_option.h"
#include "verification/criteria/cases/covers.h"
#include "verification/criteria/cases/criterion_forms.h"
#include "verification/criteria/cases/toml_keys.h"
#include "verification/support/contact_choice.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

bool is_plain_name(const std::string& text) {
    return !text.empty() && std::all_of(text.begin(), text.end(),
                                        [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

void read_runs(TomlKeys& top, const std::string& file, Case& a_case, std::vector<std::string>& problems) {
    const fs::path deck = top.text_or("deck", a_case.name + "_0000.rad");
    for (const toml::table* table : top.tables("run")) {
        TomlKeys keys(*table, file, "[[run]]", problems);
        CaseRun run;
        run.name = keys.text("name");
        run.as_built = keys.text_or("as_built", "");
        run.deck = a_case.folder / keys.text_or("deck", deck.string());
        const std::string thickness = keys.text_or("thickness", "");
        if (!thickness.empty()) run.thickness = a_case.folder / thickness;
        if (!run.name.empty() && !is_plain_name(run.name))
            keys.complain(keys.line("name"), fmt::format("name '{}' must be letters, digits, _ and -", run.name));
        for (const CaseRun& other : a_case.runs)
            if (other.name == run.name)
                keys.complain(keys.line("name"), fmt::format("name '{}' is there twice", run.name));
        Problems departures;
        parse_as_built(run.as_built, departures);
        for (const Problem& problem : departures.list())
            keys.complain(keys.line("as_built"), to_text(problem));
        if (!fs::exists(run.deck)) keys.complain(keys.line(), fmt::format("deck {} is not there", run.deck.string()));
        keys.finish();
        a_case.runs.push_back(std::move(run));
    }
}

CriterionKind read_kind(TomlKeys& keys) {
    const std::string text = keys.text("kind");
    for (const CriterionKind kind : {CriterionKind::analytic, CriterionKind::exact, CriterionKind::external,
                                     CriterionKind::cross, CriterionKind::regression})
        if (text == name(kind)) return kind;
    if (!text.empty())
        keys.complain(keys.line("kind"),
                      fmt::format("kind '{}' must be ANALYTIC, EXACT, EXTERNAL, CROSS or REGRESSION", text));
    return CriterionKind::analytic;
}

void read_criterion(const toml::table& table, const std::string& file, Case& a_case,
                    std::vector<std::string>& problems) {
    const std::string id = table["id"].value_or(std::string());
    TomlKeys keys(table, file, fmt::format("[[criterion]] '{}'", id), problems);
    Criterion criterion;
    criterion.id = keys.text("id");
    criterion.line = keys.line();
    criterion.kind = read_kind(keys);
    criterion.equation = keys.text_or("equation", "");
    criterion.with = keys.text_or("with", "");
    const auto& known = contact_choices();
    if (!criterion.with.empty() && std::find(known.begin(), known.end(), criterion.with) == known.end())
        keys.complain(keys.line("with"), fmt::format("with '{}' must be {}", criterion.with, fmt::join(known, " or ")));
    const std::string run = keys.text("run");
    const auto found =
        std::find_if(a_case.runs.begin(), a_case.runs.end(), [&](const CaseRun& r) { return r.name == run; });
    criterion.run = static_cast<size_t>(found - a_case.runs.begin());
    if (found == a_case.runs.end() && !run.empty())
        keys.complain(keys.line("run"), fmt::format("there is no [[run]] '{}'", run));
    for (const Criterion& other : a_case.criteria)
        if (other.id == criterion.id)
            keys.complain(keys.line("id"), fmt::format("id '{}' is there twice", criterion.id));
    read_form(keys, a_case.folder, criterion);
    keys.finish();
    a_case.criteria.push_back(std::move(criterion));
}

}  // namespace

std::string_view name(CriterionKind kind) {
    switch (kind) {
        case CriterionKind::analytic:
            return "ANALYTIC";
        case CriterionKind::exact:
            return "EXACT";
        case CriterionKind::external:
            return "EXTERNAL";
        case CriterionKind::cross:
            return "CROSS";
        case CriterionKind::regression:
            return "REGRESSION";
    }
    return "";
}

const std::vector<std::string>& case_families() {
    static const std::vector<std::string> families = {"patch test", "sliding continuity", "friction law", "Pmax limit"};
    return families;
}

Case read_case(const fs::path& folder, std::vector<std::string>& problems) {
    Case a_case;
    a_case.folder = folder;
    a_case.name = fs::absolute(folder).lexically_normal().filename().string();
    if (a_case.name.empty()) a_case.name = fs::absolute(folder).lexically_normal().parent_path().filename().string();
    const std::string file = (folder / "case.toml").string();
    toml::table table;
    try {
        table = toml::parse_file(file);
    } catch (const toml::parse_error& error) {
        problems.push_back(fmt::format("{}:{}: {}", file, error.source().begin.line, error.description()));
        return a_case;
    }
    TomlKeys top(table, file, "case", problems);
    a_case.statement = top.text("statement");
    a_case.source = top.text("source");
    if (!top.has("features")) top.complain(1, "key 'features' is missing");
    a_case.features = top.texts("features");
    a_case.covers = top.texts("covers");
    for (const std::string& cover : a_case.covers)
        if (!is_cover(cover))
            top.complain(
                top.line("covers"),
                fmt::format("'{}' must be 'eq 1..20', 'field NAME', 'comment 1..24' or 'departure D01..D44'", cover));
    a_case.family = top.text_or("family", "");
    if (!a_case.family.empty() &&
        std::find(case_families().begin(), case_families().end(), a_case.family) == case_families().end())
        top.complain(top.line("family"), fmt::format("case family '{}' must be one of: {}", a_case.family,
                                                     fmt::join(case_families(), ", ")));
    read_runs(top, file, a_case, problems);
    for (const toml::table* criterion : top.tables("criterion"))
        read_criterion(*criterion, file, a_case, problems);
    top.finish();

    std::vector<bool> looked_at(a_case.runs.size());
    for (const Criterion& criterion : a_case.criteria)
        if (criterion.run < looked_at.size()) looked_at[criterion.run] = true;
    for (size_t i = 0; i < looked_at.size(); ++i)
        if (!looked_at[i])
            problems.push_back(fmt::format("{}:1: [[run]] '{}' has no criterion", file, a_case.runs[i].name));
    return a_case;
}

std::vector<FileRule> rules_of(const Case& a_case, const std::string& as_built_text, bool& foreign) {
    std::vector<FileRule> same, any;
    for (const Criterion& criterion : a_case.criteria) {
        const auto* history = std::get_if<HistoryCriterion>(&criterion.form);
        if (!history) continue;
        Problems ignored;  // read_case has complained about them
        const bool is_same = parse_as_built(a_case.runs[criterion.run].as_built, ignored).text() == as_built_text;
        (is_same ? same : any).push_back(history->rule);
    }
    foreign = same.empty() && !any.empty();
    return foreign ? any : same;
}

}  // namespace type21
