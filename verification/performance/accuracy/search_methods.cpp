#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "optimized/search/search.h"
#include "reference/contact/candidates.h"
#include "verification/performance/accuracy/optimized_answer.h"
#include "verification/support/scene_builder.h"

namespace type21::accuracy {

namespace {

optimized::Tool tool_of(const DecisionTool& tool) {
    std::vector<optimized::V3> position, normal;
    position.reserve(tool.node.size());
    normal.reserve(tool.normal.size());
    for (const Vec3& x : tool.node)
        position.push_back(optimized::from(x));
    for (const Vec3& n : tool.normal)
        normal.push_back(optimized::from(n));
    return {std::move(position), std::move(normal), tool.segment};
}

/// What each implementation builds once for a tool.
class Prepared {
  public:
    explicit Prepared(const QueryBlock& block)
        : scene_(SceneBuilder().main_node(Vec3::Zero()).tool({block.tool.node, block.tool.segment}).blank({}).scene()),
          surface_(*scene_.host, scene_.model->interfaces[0]),
          candidates_(surface_, reach_of(block)),
          tool_(tool_of(block.tool)),
          search_(tool_, limits_of(block), {}),
          all_(block.tool.segment.size()) {
        std::iota(all_.begin(), all_.end(), 0);
        // A cycle before the one that is timed.
        memory_.reserve(block.queries.size());
        for (size_t q = 0; q < block.queries.size(); ++q) {
            optimized::Memory memory;
            const OptimizedQuery query(block.tool, block.queries[q]);
            search_.find(optimized::from(block.before[q]), query.reach(), {}, memory);
            memory_.push_back(memory);
        }
    }
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;

    const std::vector<int>& all() const { return all_; }
    std::vector<int> candidates(const Vec3& point) const { return candidates_.at(point); }
    const optimized::Search& search() const { return search_; }
    const optimized::Memory& memory(size_t query) const { return memory_[query]; }

  private:
    static double reach_of(const QueryBlock& block) {
        double reach = 0;
        for (const ContactQuery& query : block.queries)
            reach = std::max({reach, query.gap, query.depth, query.proximity_reach});
        return reach;
    }
    static optimized::CaptureLimits limits_of(const QueryBlock& block) {
        optimized::CaptureLimits limits;
        for (const ContactQuery& query : block.queries) {
            limits.outward = std::max({limits.outward, query.gap, query.proximity_reach});
            limits.inward = std::max(limits.inward, query.depth);
        }
        return limits;
    }

    HostScene scene_;
    reference::ToolSurface surface_;
    reference::Candidates candidates_;
    optimized::Tool tool_;
    optimized::Search search_;
    std::vector<int> all_;
    std::vector<optimized::Memory> memory_;
};

using PreparedBlocks = std::map<const QueryBlock*, std::unique_ptr<Prepared>>;

}  // namespace

std::vector<Method> search_methods(const std::vector<QueryBlock>& blocks, const std::vector<BlockQuery>& queries) {
    const auto prepared = std::make_shared<PreparedBlocks>();
    for (const QueryBlock& block : blocks)
        prepared->emplace(&block, std::make_unique<Prepared>(block));
    // Looked up before the time is taken.
    std::vector<const Prepared*> of;
    of.reserve(queries.size());
    for (const BlockQuery& one : queries)
        of.push_back(prepared->at(one.block).get());

    const auto staged = [&queries](size_t q, std::vector<int> segments) {
        const BlockQuery& one = queries[q];
        const ToolCandidates candidates(one.tool(), std::move(segments));
        return answer_of(staged_impact(one.query(), candidates.segments()), one.query().gap);
    };
    const auto filtered = [&queries](size_t q, const std::vector<int>& segments) {
        return OptimizedQuery(queries[q].tool(), queries[q].query()).among(segments);
    };
    std::vector<Method> methods;
    const auto add = [&](const char* name, const char* implementation, const char* what, auto answer) {
        methods.push_back(
            {name, implementation, what, "search", true, {}, [prepared, answer](size_t q) { return answer(q); }});
    };
    add("all segments", "reference", "the node is projected on every sub-triangle of the tool",
        [=](size_t q) { return staged(q, of[q]->all()); });
    add("tree of boxes", "reference", "segments whose grown box contains the node",
        [=, &queries](size_t q) { return staged(q, of[q]->candidates(queries[q].query().point)); });
    add("all segments", "optimized", "the node is projected on every sub-triangle of the tool",
        [=](size_t q) { return filtered(q, of[q]->all()); });
    add("the reference's tree", "optimized", "segments whose grown box contains the node",
        [=, &queries](size_t q) { return filtered(q, of[q]->candidates(queries[q].query().point)); });
    add("tree of capture volumes", "optimized", "segments whose capture volume contains the node",
        [=, &queries](size_t q) {
            const OptimizedQuery query(queries[q].tool(), queries[q].query());
            return answer_of(of[q]->search().search(query.point(), query.reach(), {}), queries[q].query().gap);
        });
    add("certificates, then the tree", "optimized",
        "the sub-triangle of the cycle before, where it is proven that no other can be retained",
        [=, &queries](size_t q) {
            const OptimizedQuery query(queries[q].tool(), queries[q].query());
            optimized::Memory memory = of[q]->memory(queries[q].number);
            return answer_of(of[q]->search().find(query.point(), query.reach(), {}, memory).retained,
                             queries[q].query().gap);
        });
    return methods;
}

}  // namespace type21::accuracy
