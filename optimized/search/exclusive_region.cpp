// Margins and neighbours of the sub-triangles of a segment, found when they are first asked for.
#include "optimized/search/search.h"
#include "optimized/search/separating_lines.h"

namespace type21::optimized {

namespace {

/// Segments whose boxes meet one: beyond this many a core is not worth its set-up.
constexpr size_t most_neighbours = 96;

float rounded_up(double margin) {
    return std::nextafter(static_cast<float>(margin), 2.0F);
}

/// Sides of a segment: corners at their ends.
struct Side {
    int one, other;
    bool same(const Side& s) const { return (one == s.one && other == s.other) || (one == s.other && other == s.one); }
};
/// Side i of a quad is one of sub-triangle i + 1; those of a triangle lie opposite to A, B, C.
int sides_of(const std::array<int, 4>& corner, bool triangle, std::array<Side, 4>& sides) {
    if (triangle) {
        sides = {Side{corner[0], corner[1]}, Side{corner[1], corner[2]}, Side{corner[2], corner[0]}, Side{-1, -1}};
        return 3;
    }
    sides = {Side{corner[0], corner[1]}, Side{corner[1], corner[2]}, Side{corner[2], corner[3]},
             Side{corner[3], corner[0]}};
    return 4;
}

}  // namespace

int Search::partner(int place, int side) const {
    const int segment = segment_of(place), piece = piece_of(place);
    if (tool_.is_triangle(segment) || side == 0)
        return over_[static_cast<size_t>(place + (tool_.is_triangle(segment) ? side : 0))].load(
            std::memory_order_relaxed);
    // B is shared with the sub-triangle before, C with the next one.
    return place_of(segment, side == 1 ? piece % 4 + 1 : (piece + 2) % 4 + 1);
}

/// The corner of a weight as a rank of vertices; the centre of a quad as -1 - segment.
int Search::vertex_at(int place, int i) const {
    const int segment = segment_of(place);
    const bool triangle = tool_.is_triangle(segment);
    if (i == 0 && !triangle) return -1 - segment;
    const PieceCorners k = piece_corners(triangle, piece_of(place));
    return tool_.corner(segment)[static_cast<size_t>(i == 0 ? 2 : (i == 1 ? k.b : k.c))];
}

int Search::corner_at(int place, int vertex) const {
    for (int i = 0; i < 3; ++i)
        if (vertex_at(place, i) == vertex) return i;
    return -1;
}

/// Has no sub-triangle with a lower number that corner?
bool Search::first_at(int place, int i, std::span<const int> segments) const {
    const int vertex = vertex_at(place, i);
    for (const int s : segments)
        for (int k = 1; k <= (tool_.is_triangle(s) ? 1 : 4) && place_of(s, k) < place; ++k)
            if (corner_at(place_of(s, k), vertex) >= 0) return false;
    return true;
}

float Search::new_core(int place) const {
    find_cores(segment_of(place));
    return margins(place).alone.load(std::memory_order_acquire);
}

void Search::find_cores(int rank) const {
    const SegmentData segment = tool_.segment(rank);
    const auto pieces = static_cast<size_t>(segment.pieces());
    std::array<CaptureVolume, 4> own;
    std::array<Box, 4> own_box;
    std::array<SeparatingLines, 4> own_lines;
    std::vector<ExclusiveMargins> own_margins;
    own_margins.reserve(4);
    Box box;
    for (size_t k = 0; k < pieces; ++k) {
        own[k] = prism(segment, static_cast<int>(k) + 1, limits_);
        own_box[k] = own[k].box();
        own_lines[k] = outer_lines(own[k]);
        own_margins.emplace_back(own[k]);
        box.extend(own_box[k]);
    }
    // Who lies over the sides of the segment: the one with the lowest number.
    std::array<Side, 4> side, facing_side;
    const int sides = sides_of(tool_.corner(rank), segment.triangle, side);
    std::array<int, 4> over{-1, -1, -1, -1};
    std::array<int, most_neighbours> near;
    size_t neighbours = 0;
    tree_.meeting(box, [&](int other) {
        if (neighbours++ >= most_neighbours) return;
        near[neighbours - 1] = other;
        if (other == rank) return;
        const bool triangle = tool_.is_triangle(other);
        const int facing = sides_of(tool_.corner(other), triangle, facing_side);
        for (size_t i = 0; i < static_cast<size_t>(sides); ++i) {
            for (size_t j = 0; j < static_cast<size_t>(facing); ++j) {
                if (!side[i].same(facing_side[j])) continue;
                const int place = place_of(other, triangle ? 1 : static_cast<int>(j) + 1);
                if (over[i] < 0 || place < over[i]) over[i] = place;
            }
        }
    });
    const auto first = 4 * static_cast<size_t>(rank);
    for (size_t i = 0; i < 4; ++i)
        over_[first + i].store(over[i], std::memory_order_relaxed);
    const bool crowded = neighbours > most_neighbours;
    // Where each sub-triangle may lead.
    std::array<unsigned, 4> leads{};
    for (size_t k = 0; k < pieces && !crowded; ++k) {
        const int place = place_of(rank, static_cast<int>(k) + 1);
        for (int i = 0; i < 3; ++i)
            leads[k] |= static_cast<unsigned>(first_at(place, i, {near.data(), neighbours})) << i;
    }
    for (size_t i = 0; i < neighbours && !crowded; ++i) {
        const SegmentData facing = tool_.segment(near[i]);
        for (size_t j = 0; j < static_cast<size_t>(facing.pieces()); ++j) {
            const bool mine = near[i] == rank;
            const CaptureVolume apart = mine ? own[j] : prism(facing, static_cast<int>(j) + 1, limits_);
            const Box apart_box = mine ? own_box[j] : apart.box();
            const SeparatingLines lines = mine ? own_lines[j] : outer_lines(apart);
            const int place = place_of(near[i], static_cast<int>(j) + 1);
            for (size_t k = 0; k < pieces; ++k) {
                if ((mine && j == k) || !apart_box.meets(own_box[k])) continue;
                int beyond = 2;
                while (beyond >= 0 && partner(place_of(rank, static_cast<int>(k) + 1), beyond) != place)
                    --beyond;
                own_margins[k].keep_from(lines, beyond);
                for (int c = 0; c < 3; ++c) {
                    if ((leads[k] >> c & 1U) == 0) continue;
                    const int shared = corner_at(place, vertex_at(place_of(rank, static_cast<int>(k) + 1), c));
                    const bool harmless =
                        shared < 0 ? own_margins[k].apart_at(lines, c)
                                   : slope_is_not_zero(facing, local_segment(facing), static_cast<int>(j) + 1, shared);
                    if (!harmless) leads[k] &= ~(1U << c);
                }
            }
        }
    }
    for (size_t k = 0; k < pieces; ++k) {
        const int place = place_of(rank, static_cast<int>(k) + 1);
        Margins& found = margins(place);
        float alone = rounded_up(crowded ? 1.0 : own_margins[k].alone());
        if (crowded || !a_priori_bounded(place)) alone = std::nextafter(alone + beyond_foreseen, 2 * beyond_foreseen);
        found.pair.store(rounded_up(crowded ? 1.0 : own_margins[k].pair()), std::memory_order_relaxed);
        leads_[first + k].store(static_cast<unsigned char>(leads[k]), std::memory_order_relaxed);
        found.alone.store(alone, std::memory_order_release);
    }
}

}  // namespace type21::optimized
