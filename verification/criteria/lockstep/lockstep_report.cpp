#include "verification/criteria/lockstep/lockstep_report.h"

#include <cmath>

#include <fmt/format.h>

#include "verification/support/build_info.h"

namespace type21 {

namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    if (std::isfinite(value)) return value;
    return "inf";
}

std::string place_text(const LockstepPlace& place) {
    const std::string node = place.node != 0 ? fmt::format(", node {}", place.node) : "";
    return fmt::format("cycle {} (t = {:.9g}), interface {}{}", place.cycle, place.time, place.interface, node);
}

Json place_json(const LockstepPlace& place) {
    return {{"cycle", place.cycle}, {"time", place.time}, {"interface", place.interface}, {"node", place.node}};
}

std::string counts(const LockstepResult& r) {
    return fmt::format("{} decisions in {} cycles, {} in contact; {} decisions differ", r.decisions, r.cycles,
                       r.in_contact, r.different);
}

std::string table(const LockstepResult& r) {
    std::string text =
        fmt::format("  {:<10} {:>10} {:>10} {:>10} {:>10}  where\n", "", "compared", "same bits", "largest", "99 %");
    for (const UlpTally& one : r.tally) {
        if (one.compared() == 0) continue;
        const std::string where = one.largest() > 0 ? place_text(one.where()) : "";
        text += fmt::format("  {:<10} {:>10} {:>10} {:>10.3g} {:>10.3g}  {}\n", one.name(), one.compared(), one.equal(),
                            one.largest(), one.percentile(0.99), where);
    }
    return text;
}

std::string trouble(const LockstepRecord& record) {
    if (!record.error.empty()) return record.error;
    const LockstepResult& r = record.result;
    if (r.first_decision) return fmt::format("{}: {}", place_text(r.first_decision->place), r.first_decision->what);
    if (r.first_force) return fmt::format("{}: {}", place_text(r.first_force->place), r.first_force->what);
    return "";
}

Json result_json(const LockstepResult& r) {
    Json json{{"cycles", r.cycles},       {"decisions", r.decisions}, {"in_contact", r.in_contact},
              {"different", r.different}, {"grazing", r.grazing},     {"lists_different", r.lists}};
    for (const auto& [key, first] : {std::pair{"first_decision", &r.first_decision}, {"first_force", &r.first_force}}) {
        if (!*first) continue;
        json[key] = place_json((*first)->place);
        json[key]["what"] = (*first)->what;
    }
    for (const UlpTally& one : r.tally)
        json["quantities"].push_back({{"name", one.name()},
                                      {"compared", one.compared()},
                                      {"same_bits", one.equal()},
                                      {"largest_ulps", number(one.largest())},
                                      {"p99_ulps", number(one.percentile(0.99))},
                                      {"where", place_json(one.where())}});
    return json;
}

}  // namespace

std::string to_text(const std::vector<LockstepRecord>& records) {
    std::string text;
    LockstepResult all;
    size_t bad = 0, refused = 0;
    double apart = -1;
    std::string apart_where;
    for (const LockstepRecord& record : records) {
        if (record.refused) {
            ++refused;
            text += fmt::format("{}: refused: {}\n", record.target.name, record.error);
            continue;
        }
        if (!record.ok()) {
            ++bad;
            text += fmt::format("{}: DIFFERS: {}\n  {}\n", record.target.name, trouble(record), counts(record.result));
        }
        if (record.apart.value_or(-1) > apart) {
            apart = *record.apart;
            apart_where = fmt::format("{} {}", record.target.name, record.apart_where);
        }
        all += record.result;
    }
    text += fmt::format("{} runs, {} refused: {}\n", records.size(), refused, counts(all));
    text += "differences in ulps of the magnitudes that enter a number:\n" + table(all);
    if (all.grazing > 0)
        text += fmt::format("{} times a node penetrated in one implementation only, by no more than rounding\n",
                            all.grazing);
    if (apart >= 0)
        text +=
            fmt::format("separate runs: histories differ by at most {:.3g} of their scale ({})\n", apart, apart_where);
    if (bad == 0)
        text += fmt::format("all decisions are the same, all numbers agree within {} ulps\n", lockstep_ulps);
    else
        text += fmt::format("{} of {} runs DIFFER\n", bad, records.size());
    return text;
}

Json to_json(const std::vector<LockstepRecord>& records) {
    const BuildInfo& build = build_info();
    Json json{{"program", {{"version", build.version}, {"commit", build.commit}, {"cpu", build.cpu}}},
              {"ulps_allowed", lockstep_ulps},
              {"ok", true},
              {"all", nullptr},
              {"runs", Json::array()}};
    LockstepResult all;
    bool ok = true;
    for (const LockstepRecord& record : records) {
        ok = ok && record.ok();
        all += record.result;
        Json one = result_json(record.result);
        one["name"] = record.target.name;
        one["deck"] = record.target.run.deck.filename().string();
        one["as_built"] = record.target.run.as_built;
        one["ok"] = record.ok();
        one["refused"] = record.refused;
        one["error"] = record.error;
        one["seconds"] = record.seconds;
        if (record.apart) {
            one["free_runs_apart"] = number(*record.apart);
            one["free_runs_where"] = record.apart_where;
        }
        json["runs"].push_back(std::move(one));
    }
    json["ok"] = ok;
    json["all"] = result_json(all);
    return json;
}

CriterionResult lockstep_criterion(const LockstepRecord& record, const std::string& case_name, const std::string& run) {
    CriterionResult criterion;
    criterion.id = "lockstep";
    criterion.case_name = case_name;
    criterion.run = run;
    criterion.kind = "CROSS";
    criterion.equation = "optimized = reference";
    criterion.expected = "the same decisions";
    criterion.got = fmt::format("{} of {} differ", record.result.different, record.result.decisions);
    criterion.difference = record.result.largest();
    criterion.tolerance = lockstep_ulps;
    criterion.unit = "ulps";
    criterion.reason = "The same equations, with a few roundings in another order.";
    criterion.ok = record.ok() && !record.refused;
    criterion.seconds = record.seconds;
    if (!criterion.ok) criterion.detail = trouble(record);
    return criterion;
}

}  // namespace type21
