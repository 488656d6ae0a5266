// Margins, neighbours and leading corners of the sub-triangles of a segment, found when first needed.
#include "optimized/search/search.h"
#include "optimized/search/separating_lines.h"

namespace type21::optimized {

namespace {

/// With more segments whose boxes meet that of a segment, its exclusive regions are not worth their set-up.
constexpr size_t most_neighbours = 96;

float rounded_up(double margin) {
    return std::nextafter(static_cast<float>(margin), 2.0F);
}

/// A side of a segment: the vertices at its ends.
struct Side {
    int one, other;
    bool same(const Side& s) const { return (one == s.one && other == s.other) || (one == s.other && other == s.one); }
};
/// Side i of a quad is one of sub-triangle i + 1; those of a triangle lie opposite to A, B, C.
int sides_of(const std::array<int, 4>& corner, bool is_triangle, std::array<Side, 4>& sides) {
    if (is_triangle) {
        sides = {Side{corner[0], corner[1]}, Side{corner[1], corner[2]}, Side{corner[2], corner[0]}, Side{-1, -1}};
        return 3;
    }
    sides = {Side{corner[0], corner[1]}, Side{corner[1], corner[2]}, Side{corner[2], corner[3]},
             Side{corner[3], corner[0]}};
    return 4;
}

}  // namespace

SubTriangleId Search::neighbour_over(SubTriangleId id, int side) const {
    const int segment = id.segment(), triangle = id.triangle();
    const bool is_triangle = tool_.is_triangle(segment);
    if (is_triangle || side == 0)
        return neighbour_[static_cast<size_t>(id.code() + (is_triangle ? side : 0))].load(std::memory_order_relaxed);
    // C is shared with the next sub-triangle, B with the one before.
    return {segment, side == 1 ? triangle % 4 + 1 : (triangle + 2) % 4 + 1};
}

/// A corner as a rank of vertices; the centre of a quad as -1 - segment.
int Search::vertex_at(SubTriangleId id, int corner) const {
    const int segment = id.segment();
    const bool is_triangle = tool_.is_triangle(segment);
    if (corner == 0 && !is_triangle) return -1 - segment;
    const SubTriangleCorners k = sub_triangle_corners(is_triangle, id.triangle());
    return tool_.corner(segment)[static_cast<size_t>(corner == 0 ? 2 : (corner == 1 ? k.b : k.c))];
}

int Search::corner_at(SubTriangleId id, int vertex) const {
    for (int i = 0; i < 3; ++i)
        if (vertex_at(id, i) == vertex) return i;
    return -1;
}

/// Has no sub-triangle with a lower number this corner?
bool Search::is_lowest_at(SubTriangleId id, int corner, std::span<const int> segments) const {
    const int vertex = vertex_at(id, corner);
    for (const int s : segments)
        for (int k = 1; k <= (tool_.is_triangle(s) ? 1 : 4) && SubTriangleId(s, k) < id; ++k)
            if (corner_at({s, k}, vertex) >= 0) return false;
    return true;
}

float Search::new_exclusive_margin(SubTriangleId id) const {
    find_exclusive_regions(id.segment());
    return margins(id).exclusive.load(std::memory_order_acquire);
}

void Search::find_exclusive_regions(int rank) const {
    const SegmentData segment = tool_.segment(rank);
    const auto sub_triangles = static_cast<size_t>(segment.sub_triangles());
    std::array<CaptureVolume, 4> own;
    std::array<Box, 4> own_box;
    std::array<SeparatingLines, 4> own_lines;
    std::vector<ExclusiveMargins> own_margins;
    own_margins.reserve(4);
    Box box;
    for (size_t k = 0; k < sub_triangles; ++k) {
        own[k] = capture_volume(segment, static_cast<int>(k) + 1, limits_);
        own_box[k] = own[k].box();
        own_lines[k] = separating_lines(own[k]);
        own_margins.emplace_back(own[k]);
        box.extend(own_box[k]);
    }
    // The sub-triangle over each side of the segment; of several, the one with the lowest number.
    std::array<Side, 4> side, facing_side;
    const int sides = sides_of(tool_.corner(rank), segment.is_triangle, side);
    std::array<SubTriangleId, 4> over;
    over.fill(SubTriangleId::none());
    std::array<int, most_neighbours> near;
    size_t neighbours = 0;
    tree_.meeting(box, [&](int other) {
        if (neighbours++ >= most_neighbours) return;
        near[neighbours - 1] = other;
        if (other == rank) return;
        const bool is_triangle = tool_.is_triangle(other);
        const int facing = sides_of(tool_.corner(other), is_triangle, facing_side);
        for (size_t i = 0; i < static_cast<size_t>(sides); ++i) {
            for (size_t j = 0; j < static_cast<size_t>(facing); ++j) {
                if (!side[i].same(facing_side[j])) continue;
                const SubTriangleId id(other, is_triangle ? 1 : static_cast<int>(j) + 1);
                if (!over[i].exists() || id < over[i]) over[i] = id;
            }
        }
    });
    const auto first = 4 * static_cast<size_t>(rank);
    for (size_t i = 0; i < 4; ++i)
        neighbour_[first + i].store(over[i], std::memory_order_relaxed);
    const bool crowded = neighbours > most_neighbours;
    // At which corners each sub-triangle may lead.
    std::array<unsigned, 4> leads{};
    for (size_t k = 0; k < sub_triangles && !crowded; ++k) {
        for (int c = 0; c < 3; ++c)
            leads[k] |=
                static_cast<unsigned>(is_lowest_at({rank, static_cast<int>(k) + 1}, c, {near.data(), neighbours})) << c;
    }
    for (size_t i = 0; i < neighbours && !crowded; ++i) {
        const SegmentData facing = tool_.segment(near[i]);
        const LocalSegment facing_local = local_segment(facing);
        for (size_t j = 0; j < static_cast<size_t>(facing.sub_triangles()); ++j) {
            const bool mine = near[i] == rank;
            const SubTriangleId rival(near[i], static_cast<int>(j) + 1);
            const CaptureVolume volume = mine ? own[j] : capture_volume(facing, rival.triangle(), limits_);
            const Box rival_box = mine ? own_box[j] : volume.box();
            const SeparatingLines lines = mine ? own_lines[j] : separating_lines(volume);
            for (size_t k = 0; k < sub_triangles; ++k) {
                if ((mine && j == k) || !rival_box.meets(own_box[k])) continue;
                const SubTriangleId id(rank, static_cast<int>(k) + 1);
                int shared_side = 2;
                while (shared_side >= 0 && neighbour_over(id, shared_side) != rival)
                    --shared_side;
                own_margins[k].exclude(lines, shared_side);
                for (int c = 0; c < 3; ++c) {
                    if ((leads[k] >> c & 1U) == 0) continue;
                    const int corner = corner_at(rival, vertex_at(id, c));
                    const bool harmless = corner < 0
                                              ? own_margins[k].apart_at(lines, c)
                                              : slope_is_not_zero(facing, facing_local, rival.triangle(), corner);
                    if (!harmless) leads[k] &= ~(1U << c);
                }
            }
        }
    }
    for (size_t k = 0; k < sub_triangles; ++k) {
        const SubTriangleId id(rank, static_cast<int>(k) + 1);
        Margins& found = margins(id);
        float exclusive = rounded_up(crowded ? 1.0 : own_margins[k].exclusive());
        if (crowded || !a_priori_bounded(id))
            exclusive = std::nextafter(exclusive + not_a_priori_bounded, 2 * not_a_priori_bounded);
        found.neighbour.store(rounded_up(crowded ? 1.0 : own_margins[k].neighbour_zone()), std::memory_order_relaxed);
        leads_[first + k].store(static_cast<unsigned char>(leads[k]), std::memory_order_relaxed);
        found.exclusive.store(exclusive, std::memory_order_release);
    }
}

}  // namespace type21::optimized
