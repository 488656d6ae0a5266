/// @file Methods that answer the same queries: number types, implementations, searches.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verification/decisions/queries/tool_candidates.h"
#include "verification/performance/accuracy/query_scene.h"

namespace type21::accuracy {

/// One query of a block, with the segments that may take its node.
struct BlockQuery {
    const QueryBlock* block = nullptr;  ///< must outlive this
    size_t number = 0;                  ///< of the query in its block
    std::unique_ptr<ToolCandidates> candidates;

    const DecisionTool& tool() const { return block->tool; }
    const ContactQuery& query() const { return block->queries[number]; }
};

/// The queries of all blocks, in order. The blocks must outlive them.
std::vector<BlockQuery> all_queries(const std::vector<QueryBlock>& blocks);

/// The answer of a method.
struct Answer {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    double penetration = 0;  ///< g - delta, 0 without contact [length]
    bool undecided = false;  ///< the arithmetic cannot tell
    int stage = 0;           ///< the stage that settled it: index into Method::stages
};

/// One way to answer a query.
struct Method {
    std::string name;                 ///< "double"
    std::string implementation;       ///< "reference", "optimized"; empty: arithmetic only
    std::string what;                 ///< in a sentence
    std::string group;                ///< "arithmetic": candidates are given; "search": they are found in the time
    bool exact = false;               ///< it promises never to be wrong
    std::vector<std::string> stages;  ///< names, in order; empty: none
    std::function<Answer(size_t number)> answer;  ///< of a query, by its rank among all queries
};

/// Methods that are given the candidates: float, double, double with a bound, interval, rational numbers, the reference
/// in stages, the optimized decision.
/// @param queries  of one scene; must outlive the methods
std::vector<Method> arithmetic_methods(const std::vector<BlockQuery>& queries);
/// Methods that find the candidates themselves: all segments, the reference's tree, the optimized tree, and the
/// optimized tree with its memory of the cycle before.
std::vector<Method> search_methods(const std::vector<QueryBlock>& blocks, const std::vector<BlockQuery>& queries);

/// In single precision.
Answer answer_by_float(const BlockQuery& one);
/// In interval arithmetic. In a file of its own, since it changes the rounding mode.
Answer answer_by_interval(const BlockQuery& one);
/// @param gap  g of the query [length]
Answer answer_of(const reference::StagedImpact& impact, double gap);

}  // namespace type21::accuracy
