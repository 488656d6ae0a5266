/// @file One question, one answer, through a search: as projection/query.h, but the search has to find the segments.
#pragma once

#include "optimized/projection/query.h"
#include "optimized/search/search_kind.h"

namespace type21::optimized {

/// As decide_query, which lets every segment compete. Here only those compete that the search finds, and it looks from
/// an earlier place of the node: with the tree the node has a memory of a place near by, and the sorted search has a
/// list that was made there, at the edge of its margin. For verification; a tool and a search are built for each call.
/// @throws std::invalid_argument as decide_query
Decision decide_query(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                      const std::vector<std::array<int, 4>>& segments, const Vec3& p, double gap, double depth,
                      double reach, SearchKind search);

}  // namespace type21::optimized
