#include "verification/results/record/node_columns.h"

#include <algorithm>
#include <set>

namespace type21 {
namespace {

template <int axis>
std::vector<NodeColumn> axis_columns(const std::string& suffix) {
    using R = CycleRecord;
    return {
        {"D" + suffix, [](const R& r, size_t n) { return (*r.displacement)[n][axis]; }},
        {"V" + suffix, [](const R& r, size_t n) { return r.motion->velocity[n][axis]; }},
        {"A" + suffix, [](const R& r, size_t n) { return (*r.acceleration)[n][axis]; }},
        {"VR" + suffix, [](const R& r, size_t n) { return (*r.angular_velocity)[n][axis]; }},
        {"REAC" + suffix, [](const R& r, size_t n) { return (*r.reaction)[n][axis]; }},
        {"REAC" + suffix + suffix, [](const R& r, size_t n) { return (*r.reaction_moment)[n][axis]; }},
        {suffix, [](const R& r, size_t n) { return r.motion->position[n][axis]; }},
    };
}

}  // namespace

const std::vector<NodeColumn>& node_columns() {
    static const std::vector<NodeColumn> columns = [] {
        const std::vector<NodeColumn> x = axis_columns<0>("X");
        const std::vector<NodeColumn> y = axis_columns<1>("Y");
        const std::vector<NodeColumn> z = axis_columns<2>("Z");
        std::vector<NodeColumn> all;
        for (size_t kind = 0; kind < x.size(); ++kind)
            for (const auto* axis : {&x, &y, &z})
                all.push_back((*axis)[kind]);
        // Where OpenRadioss writes it: after the rotations and before the reactions.
        const auto reaction =
            std::find_if(all.begin(), all.end(), [](const NodeColumn& c) { return c.name == "REACX"; });
        all.insert(reaction, {"TEMP", [](const CycleRecord& r, size_t n) {
                                  return r.temperature->empty() ? 0.0 : (*r.temperature)[n];
                              }});
        return all;
    }();
    return columns;
}

NodeHistory node_history(const Model& model) {
    std::set<int> nodes;
    std::set<std::string> variables;
    for (const HistoryRequest& request : model.histories) {
        if (request.kind != HistoryRequest::Kind::node) continue;
        nodes.insert(request.objects.begin(), request.objects.end());
        variables.insert(request.variables.begin(), request.variables.end());
    }
    NodeHistory history{{nodes.begin(), nodes.end()}, {}};
    for (const NodeColumn& column : node_columns())
        if (variables.contains(column.name)) history.columns.push_back(column);
    return history;
}

}  // namespace type21
