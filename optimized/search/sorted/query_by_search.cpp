#include "optimized/search/sorted/query_by_search.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <memory>

#include "optimized/search/search.h"
#include "optimized/search/sorted/candidate_lists.h"

namespace type21::optimized {

namespace {

/// A place beside p. Each coordinate is a full `way` or none away, up or down, as the last bits of the coordinate say.
V3 place_before(const V3& p, double way) {
    const auto moved = [&](double x) {
        const auto bits = std::bit_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U >> 62;
        return bits == 0 ? x : (bits == 1 ? x + way : x - way);
    };
    return {moved(p.x), moved(p.y), moved(p.z)};
}

/// Mean size of the boxes of the segments [length].
double mean_extent(const std::vector<V3>& position, const std::vector<std::array<int, 4>>& segments) {
    double sum = 0;
    for (const auto& corner : segments) {
        Box box;
        for (const int node : corner)
            box.extend(position[static_cast<size_t>(node)]);
        sum += largest(box.high - box.low);
    }
    return segments.empty() ? 0 : sum / static_cast<double>(segments.size());
}

}  // namespace

Decision decide_query(const std::vector<Vec3>& nodes, const std::vector<Vec3>& normals,
                      const std::vector<std::array<int, 4>>& segments, const Vec3& p, double gap, double depth,
                      double reach, SearchKind kind) {
    // It also tests the input.
    if (segments.empty()) return decide_query(nodes, normals, segments, p, gap, depth, reach);
    check_query(nodes, normals, segments, p, gap, depth, reach);
    std::vector<V3> position(nodes.size()), normal(nodes.size());
    std::transform(nodes.begin(), nodes.end(), position.begin(), from);
    std::transform(normals.begin(), normals.end(), normal.begin(), from);
    const double margin = 0.2 * mean_extent(position, segments);  // a Bumult of 0.2 on the sides of the tool
    const Tool tool(position, normal, segments);
    const Search search(tool, {std::max({gap, reach, 0.0}), std::max(depth, 0.0), 0.01, false}, {}, kind);
    const V3 y = from(p), before = place_before(y, margin);

    const auto batch = std::make_unique<Search::Batch>();
    Memory memory;
    batch->count = 1;
    batch->depth = depth;
    batch->proximity = reach;
    batch->gap[0] = gap;
    batch->active[0] = true;
    const auto find = [&](const V3& at) {
        batch->memory = &memory;
        for (int a = 0; a < 3; ++a)
            batch->y[a][0] = at[a];
        search.find(*batch, {});
    };
    CandidateLists lists(search.boxes(), margin);
    if (kind == SearchKind::tree) {
        find(before);
    } else {
        // Other nodes make the list one among many, as in a step.
        std::vector<V3> all{before};
        all.insert(all.end(), position.begin(), position.end());
        lists.sort(std::move(all));
        if (!lists.covers(0, y)) lists.sort({y});  // the way was rounded up
        batch->lists = lists.all();
    }
    find(y);
    const Retained retained = batch->retained(0);
    if (!retained.exists()) return {};
    return decision_of(retained);
}

}  // namespace type21::optimized
