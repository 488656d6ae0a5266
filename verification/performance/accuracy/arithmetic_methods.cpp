#include <cmath>

#include "optimized/projection/decide.h"
#include "reference/exact/bounded.h"
#include "verification/performance/accuracy/number_answer.h"
#include "verification/performance/accuracy/optimized_answer.h"

namespace type21::accuracy {

std::vector<Asked> all_asked(const std::vector<QuestionBlock>& blocks) {
    std::vector<Asked> asked;
    for (const QuestionBlock& block : blocks)
        for (size_t q = 0; q < block.queries.size(); ++q)
            asked.push_back({&block, q, std::make_unique<Question>(block.tool, block.queries[q])});
    return asked;
}

Answer answer_of(const reference::StagedImpact& impact, double gap) {
    Answer answer{impact.kind, impact.segment, impact.triangle, impact.side};
    answer.stage = static_cast<int>(impact.stage);
    const auto& projection = impact.projection;
    if (impact.kind == Kind::contact)
        answer.penetration = gap - projection.height * projection.normal.norm() / projection.slope;
    return answer;
}

std::vector<Method> arithmetic_methods(const std::vector<Asked>& asked) {
    using reference::DecisionInput;
    const auto input = [&asked](size_t q) -> const DecisionInput& { return asked[q].question->input(); };
    const auto gap = [&asked](size_t q) { return asked[q].query().gap; };
    const auto none_near = [&asked](size_t q) { return asked[q].question->segments().empty(); };
    std::vector<Method> methods;
    methods.push_back({"float", "", "single precision throughout", "arithmetic", false, {}, [=](size_t q) {
                           return answer_by_float(input(q));
                       }});
    methods.push_back({"double", "", "double precision throughout", "arithmetic", false, {}, [=](size_t q) {
                           return answer_in<double>(input(q), [](double x) { return x; });
                       }});
    methods.push_back(
        {"double with bound",
         "",
         "each double carries a proven bound of its error; where that is not enough it cannot tell",
         "arithmetic",
         true,
         {},
         [=](size_t q) { return answer_in<reference::Bounded>(input(q), [](const auto& x) { return x.value(); }); }});
    methods.push_back({"interval",
                       "",
                       "intervals of doubles alone; where they overlap it cannot tell",
                       "arithmetic",
                       true,
                       {},
                       [=](size_t q) { return answer_by_interval(input(q)); }});
    methods.push_back({"exact", "", "rational numbers alone", "arithmetic", true, {}, [=](size_t q) {
                           return answer_of(exact_impact(input(q)), gap(q));
                       }});
    methods.push_back({"in stages",
                       "reference",
                       "double with bound, then interval, then rational numbers, each where the one before cannot tell",
                       "arithmetic",
                       true,
                       {"nothing near", "double with bound", "interval", "rational numbers"},
                       [=](size_t q) {
                           Answer answer = answer_of(staged_impact(input(q)), gap(q));
                           answer.stage = none_near(q) ? 0 : answer.stage + 1;
                           return answer;
                       }});
    methods.push_back({"in stages",
                       "optimized",
                       "double with foreseen bounds, then a proof of a tie, 100 bits, whole numbers",
                       "arithmetic",
                       true,
                       {"nothing near", "double with bound", "proven tie", "100 bits", "whole numbers"},
                       [=, &asked](size_t q) {
                           const Asked& one = asked[q];
                           const OptimizedQuestion question(one.tool(), one.query());
                           Answer answer = question.among(one.question->segments());
                           answer.stage = none_near(q) ? 0 : answer.stage + 1;
                           return answer;
                       }});
    return methods;
}

}  // namespace type21::accuracy
