#include "verification/results/record/run_summary.h"

#include <algorithm>

#include "verification/decisions/queries/decision_text.h"
#include "verification/results/record/interface_columns.h"
#include "verification/results/record/run_id.h"
#include "verification/support/build_info.h"
#include "verification/support/output_file.h"

namespace type21 {
namespace {

using Json = nlohmann::ordered_json;

Json residual_json(const Residual& residual) {
    return {{"relative_residual", residual.relative}, {"cycle", residual.cycle}, {"time", residual.time}};
}

Json balance_json(const InterfaceBalance& balance) {
    return {{"force", residual_json(balance.force)},
            {"power", residual_json(balance.power)},
            {"CE_DAMP", residual_json(balance.damping_energy)},
            {"CE_FRIC", residual_json(balance.friction_energy)},
            {"heat", residual_json(balance.heat)},
            {"cycles_in_contact", balance.cycles_in_contact}};
}

/// Bytes that each effect takes per secondary node, of what it holds (bytes_per_node) or of its report in each cycle
/// (report_bytes_per_node); an effect that is absent takes none.
Json memory_json(const std::vector<std::vector<EffectMemory>>& memory, size_t interface, size_t EffectMemory::*bytes) {
    Json json = Json::object();
    if (interface >= memory.size()) return json;
    for (const EffectMemory& one : memory[interface])
        if (one.*bytes > 0) json[std::string(name(one.effect))] = one.*bytes;
    return json;
}

Json sorted_json(const optimized::SortedSearchCounts& counts, const Interface& card) {
    return {{"bumult", card.bumult.value},
            {"margin", counts.margin},
            {"cycles", counts.cycles},
            {"sorts", counts.sorts},
            {"searches", counts.searches},
            {"candidates_per_node", counts.candidates_per_node()},
            {"boxes_per_node", counts.near_per_node()},
            {"bytes", counts.bytes}};
}

Json contact_json(const ContactCount& count, const Model& model) {
    Json json = {{"secondary_nodes", count.nodes},           {"in_contact_at_end", count.in_contact},
                 {"sticking_at_end", count.sticking},        {"sliding_at_end", count.sliding},
                 {"most_in_contact", count.most_in_contact}, {"cycles_in_contact", count.cycles_in_contact},
                 {"deepest_penetration", count.deepest}};
    if (count.deepest_node >= 0) {
        json["deepest_node"] = model.nodes.id[static_cast<size_t>(count.deepest_node)];
        json["deepest_time"] = count.deepest_time;
    }
    return json;
}

}  // namespace

void RunSummary::observe(const CycleRecord& record) {
    smallest_step = cycles == 0 ? record.next_step : std::min(smallest_step, record.next_step);
    largest_step = std::max(largest_step, record.next_step);
    cycles = record.cycle + 1;
    time = record.time;
    totals = *record.totals;
    if (memory.empty())
        for (const auto& method : *record.methods)
            memory.push_back(method->memory_by_effect());
    stage_counts.resize(record.methods->size());
    for (size_t i = 0; i < stage_counts.size(); ++i)
        stage_counts[i] = (*record.methods)[i]->decision_stage_counts();
    sorted_search.clear();
    for (const auto& method : *record.methods) {
        const auto* fast = dynamic_cast<const optimized::Contact*>(method.get());
        sorted_search.push_back(fast != nullptr ? fast->sorted_search() : std::nullopt);
    }
}

std::string_view name(RunSummary::State state) {
    switch (state) {
        case RunSummary::State::running:
            return "running";
        case RunSummary::State::completed:
            return "completed";
        case RunSummary::State::stopped:
            return "stopped";
        case RunSummary::State::diverged:
            return "diverged";
        case RunSummary::State::interrupted:
            return "interrupted";
    }
    return "";
}

Json to_json(const RunSummary& summary, const HostScene& scene, const std::vector<std::string>& warnings) {
    const BuildInfo& build = build_info();
    const Model& model = *scene.host;
    std::vector<std::string> all_warnings = warnings;
    all_warnings.insert(all_warnings.end(), summary.warnings.begin(), summary.warnings.end());
    Json json = {{"program", "type21"},
                 {"schema", result_schema},
                 {"run_id", summary.run_id},
                 {"version", build.version},
                 {"commit", build.commit},
                 {"compiler", build.compiler},
                 {"flags", build.flags},
                 {"build_type", build.build_type},
                 {"cpu", build.cpu},
                 {"status", name(summary.state)},
                 {"reason", summary.reason},
                 {"cycles", summary.cycles},
                 {"time", summary.time},
                 {"smallest_step", summary.smallest_step},
                 {"largest_step", summary.largest_step},
                 {"wall_seconds", summary.wall_seconds},
                 {"warnings", all_warnings}};
    if (const auto& from = summary.restarted_from)
        json["restarted_from"] = {{"run_id", from->run_id}, {"cycle", from->cycle}, {"time", from->time}};
    json.update(model_json(scene));
    Json results = Json::array();
    for (size_t i = 0; i < summary.totals.size(); ++i) {
        Json final_values;
        for (const InterfaceColumn& column : interface_columns())
            final_values[column.name] = column.value(summary.totals[i]);
        results.push_back(
            {{"interface", model.interfaces[i].id},
             {"final", final_values},
             {"state_bytes_per_node", memory_json(summary.memory, i, &EffectMemory::bytes_per_node)},
             {"report_bytes_per_node", memory_json(summary.memory, i, &EffectMemory::report_bytes_per_node)},
             {"decisions", to_json(summary.stage_counts.at(i))},
             {"heat_to_blank", summary.totals[i].heat_to_blank},
             {"heat_to_tool", summary.totals[i].heat_to_tool},
             {"contact", contact_json(summary.contact.at(i), model)},
             {"balance", balance_json(summary.balance.at(i))}});
        if (summary.sorted_search.at(i))
            results.back()["sorted_search"] = sorted_json(*summary.sorted_search[i], model.interfaces[i]);
    }
    json["results"] = std::move(results);
    return json;
}

void write_json(const std::filesystem::path& path, const Json& json) {
    // A name in a deck may be in any encoding: bytes that are not UTF-8 are replaced.
    replace_file(path, json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n");
}

}  // namespace type21
