/// @file Ways to answer the same questions: number types, implementations, searches.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "verification/decisions/queries/question.h"
#include "verification/performance/accuracy/question_scene.h"

namespace type21::accuracy {

/// One question with what every method is given.
struct Asked {
    const QuestionBlock* block = nullptr;
    size_t number = 0;  ///< in its block
    std::unique_ptr<Question> question;

    const DecisionTool& tool() const { return block->tool; }
    const DecisionQuery& query() const { return block->queries[number]; }
};

/// The questions of all blocks, in order, each with the segments that may reach it. The blocks must outlive them.
std::vector<Asked> all_asked(const std::vector<QuestionBlock>& blocks);

/// What a method says.
struct Answer {
    Kind kind = Kind::none;
    int segment = -1;
    int triangle = 0;
    int side = 0;
    double penetration = 0;  ///< g - delta, 0 without contact [length]
    bool undecided = false;  ///< the arithmetic cannot tell
    int stage = 0;           ///< what settled it, index into Method::stages
};

/// One way to answer.
struct Method {
    std::string name;            ///< "double"
    std::string implementation;  ///< "reference", "optimized"; empty: arithmetic alone
    std::string what;            ///< in a sentence
    std::string group;           ///< "arithmetic": candidates are given; "search": they are found in the time
    bool exact = false;          ///< it promises never to be wrong
    std::vector<std::string> stages;
    std::function<Answer(size_t question)> answer;
};

/// float, double, double with a bound, interval, rational numbers, the reference in stages, the optimized decision.
/// @param asked  must outlive the methods
std::vector<Method> arithmetic_methods(const std::vector<Asked>& asked);
/// All segments, the reference's tree, the optimized one, and the optimized one with its memory of the cycle before.
std::vector<Method> search_methods(const std::vector<QuestionBlock>& blocks, const std::vector<Asked>& asked);

/// Single precision alone.
Answer answer_by_float(const reference::DecisionInput& input);
/// Interval arithmetic alone; compiled on its own, since it changes the rounding mode.
Answer answer_by_interval(const reference::DecisionInput& input);
Answer answer_of(const reference::StagedImpact& impact, double gap);

}  // namespace type21::accuracy
