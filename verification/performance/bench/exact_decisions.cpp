#include "verification/performance/bench/exact_decisions.h"

#include <algorithm>
#include <tbb/parallel_for.h>

#include <fmt/format.h>

#include "reference/contact/candidates.h"
#include "reference/contact/tool_surface.h"
#include "reference/exact/staged_impact.h"

namespace type21::bench {

std::string in_words(const Decision& d) {
    if (d.kind == Kind::none) return "none";
    return fmt::format("{}, segment {}, triangle {}, side {:+d}", d.kind == Kind::contact ? "contact" : "proximity",
                       d.segment, d.triangle, d.side);
}

struct ExactDecisions::State {
    explicit State(const BenchScene& of) : scene(of.scene), interface(of.interface), card(of.card()) {
        const Model& model = *scene.host;
        tool = std::make_unique<reference::ToolSurface>(model, card);
        double reach = card.depth;
        for (const double gap : card.secondary.search_gap)
            reach = std::max(reach, gap);
        candidates = std::make_unique<reference::Candidates>(*tool, reach);
    }

    HostScene scene;
    int interface;
    const Interface& card;
    std::unique_ptr<reference::ToolSurface> tool;
    std::unique_ptr<reference::Candidates> candidates;
};

ExactDecisions::ExactDecisions(const BenchScene& scene) : state_(std::make_unique<State>(scene)) {}
ExactDecisions::~ExactDecisions() = default;

std::vector<Decision> ExactDecisions::at(const Motion& motion, size_t most) const {
    const State& s = *state_;
    const auto& node = s.card.secondary.node;
    std::vector<Decision> out(std::min(node.size(), most));
    const ToolMotion& pose = motion.tools[static_cast<size_t>(s.card.tool)];
    const reference::ShapeOf shape_of = [&](int segment) { return s.tool->shape(segment); };
    tbb::parallel_for(tbb::blocked_range<size_t>(0, out.size(), 256), [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end(); ++i) {
            const Vec3 y = pose.rotation.transpose() * (motion.position[static_cast<size_t>(node[i])] - pose.position);
            const std::vector<int> near = s.candidates->at(y);
            if (near.empty()) continue;
            const ContactQuery query{y, s.card.secondary.search_gap[i], s.card.depth, 0.0};
            const reference::StagedImpact impact = reference::staged_impact(query, {near, shape_of});
            out[i].kind = impact.kind;
            out[i].segment = impact.segment;
            out[i].triangle = impact.triangle;
            out[i].side = impact.side;
        }
    });
    return out;
}

}  // namespace type21::bench
