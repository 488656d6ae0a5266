/// @file Makes a failing query small.
#pragma once

#include <functional>

#include "verification/decisions/queries/decision_block.h"

namespace type21 {

/// One tool and one query.
struct SingleQuery {
    DecisionTool tool;
    ContactQuery query;
};

/// Leaves out segments and nodes, makes triangles of quads and rounds numbers, as long as the query still fails.
/// @param fails  true for `single`; must be a pure function
SingleQuery shrink(SingleQuery single, const std::function<bool(const SingleQuery&)>& fails);

}  // namespace type21
