#include "verification/cli/check_output.h"
#include "verification/results/record/run_summary.h"
#include "verification/support/build_info.h"

namespace type21::cli {
namespace {

using Json = nlohmann::ordered_json;

Json problems_json(const Problems& problems) {
    Json out = Json::array();
    for (const Problem& p : problems.list())
        out.push_back({{"severity", p.severity == Severity::error ? "error" : "warning"},
                       {"file", p.place.file},
                       {"line", p.place.line},
                       {"card", p.card},
                       {"field", p.field},
                       {"value", p.value},
                       {"rule", p.rule},
                       {"remedy", p.remedy},
                       {"count", p.count}});
    return out;
}

Json range_json(const Range& range) {
    return {{"smallest", range.smallest}, {"largest", range.largest}};
}

Json time_zero_json(const Model& model, const TimeZero& zero) {
    Json penetrations = Json::array();
    for (const InitialPenetration& p : zero.penetrations)
        penetrations.push_back({{"node", model.nodes.id[static_cast<size_t>(p.node)]},
                                {"segment", p.segment + 1},
                                {"penetration", p.penetration},
                                {"distance", p.distance}});
    return {{"gap", range_json(zero.gap)},   {"depth", zero.depth},           {"stiffness", range_json(zero.stiffness)},
            {"mass", range_json(zero.mass)}, {"total_mass", zero.total_mass}, {"initial_penetrations", penetrations}};
}

}  // namespace

Json check_json(const HostScene& scene, const std::vector<TimeZero>& zero, const Problems& problems) {
    Json json = {{"program", "type21"},
                 {"version", build_info().version},
                 {"valid", true},
                 {"problems", problems_json(problems)}};
    json.update(model_json(scene));
    json["sizes"] = {{"nodes", scene.model->nodes.size()}, {"shells", scene.model->shells.size()}};
    for (size_t i = 0; i < zero.size(); ++i)
        json["interfaces"][i]["time_zero"] = time_zero_json(*scene.host, zero[i]);
    return json;
}

Json refused_json(const std::string& deck, const Problems& problems) {
    return {{"program", "type21"},
            {"version", build_info().version},
            {"valid", false},
            {"deck", deck},
            {"problems", problems_json(problems)}};
}

}  // namespace type21::cli
