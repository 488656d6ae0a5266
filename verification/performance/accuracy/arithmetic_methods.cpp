#include <cmath>

#include "optimized/projection/decide.h"
#include "reference/exact/bounded.h"
#include "verification/performance/accuracy/number_answer.h"
#include "verification/performance/accuracy/optimized_answer.h"

namespace type21::accuracy {

std::vector<BlockQuery> all_queries(const std::vector<QueryBlock>& blocks) {
    std::vector<BlockQuery> all;
    for (const QueryBlock& block : blocks)
        for (size_t q = 0; q < block.queries.size(); ++q)
            all.push_back({&block, q, std::make_unique<ToolCandidates>(block.tool, block.queries[q])});
    return all;
}

Answer answer_of(const reference::StagedImpact& impact, double gap) {
    Answer answer{impact.kind, impact.segment, impact.triangle, impact.side};
    answer.stage = static_cast<int>(impact.stage);
    const auto& projection = impact.projection;
    if (impact.kind == Kind::contact)
        answer.penetration = gap - projection.height * projection.normal.norm() / projection.slope;
    return answer;
}

std::vector<Method> arithmetic_methods(const std::vector<BlockQuery>& queries) {
    const auto gap = [&queries](size_t q) { return queries[q].query().gap; };
    const auto none_near = [&queries](size_t q) { return queries[q].candidates->ranks().empty(); };
    std::vector<Method> methods;
    methods.push_back({"float", "", "single precision throughout", "arithmetic", false, {}, [&queries](size_t q) {
                           return answer_by_float(queries[q]);
                       }});
    methods.push_back({"double", "", "double precision throughout", "arithmetic", false, {}, [&queries](size_t q) {
                           return answer_in<double>(queries[q], [](double x) { return x; });
                       }});
    methods.push_back({"double with bound",
                       "",
                       "each double carries a proven bound on its error; where that is not enough it cannot tell",
                       "arithmetic",
                       true,
                       {},
                       [&queries](size_t q) {
                           return answer_in<reference::Bounded>(queries[q], [](const auto& x) { return x.value(); });
                       }});
    methods.push_back({"interval",
                       "",
                       "intervals of doubles; where they overlap it cannot tell",
                       "arithmetic",
                       true,
                       {},
                       [&queries](size_t q) { return answer_by_interval(queries[q]); }});
    methods.push_back({"exact", "", "rational numbers", "arithmetic", true, {}, [=, &queries](size_t q) {
                           return answer_of(exact_impact(queries[q].query(), queries[q].candidates->segments()),
                                            gap(q));
                       }});
    methods.push_back({"in stages",
                       "reference",
                       "double with bound, then interval, then rational numbers, each where the one before cannot tell",
                       "arithmetic",
                       true,
                       {"nothing near", "double with bound", "interval", "rational numbers"},
                       [=, &queries](size_t q) {
                           Answer answer =
                               answer_of(staged_impact(queries[q].query(), queries[q].candidates->segments()), gap(q));
                           answer.stage = none_near(q) ? 0 : answer.stage + 1;
                           return answer;
                       }});
    methods.push_back({"in stages",
                       "optimized",
                       "double with a-priori error bounds, then a proof of a tie, double-double, integers",
                       "arithmetic",
                       true,
                       {"nothing near", "double with bound", "proven tie", "double-double", "integers"},
                       [=, &queries](size_t q) {
                           const BlockQuery& one = queries[q];
                           const OptimizedQuery query(one.tool(), one.query());
                           Answer answer = query.among(one.candidates->ranks());
                           answer.stage = none_near(q) ? 0 : answer.stage + 1;
                           return answer;
                       }});
    return methods;
}

}  // namespace type21::accuracy
