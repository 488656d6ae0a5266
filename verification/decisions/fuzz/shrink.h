/// @file Makes a failing question small.
#pragma once

#include <functional>

#include "verification/decisions/queries/query.h"

namespace type21 {

/// One tool and one question.
struct SingleQuestion {
    DecisionTool tool;
    DecisionQuery query;
};

/// Leaves out segments and nodes, makes triangles of quads and rounds numbers, as long as it still fails.
/// @param fails  true for `question`; must be a pure function
SingleQuestion shrink(SingleQuestion question, const std::function<bool(const SingleQuestion&)>& fails);

}  // namespace type21
