#include "optimized/search/search.h"

#include <cmath>

#include "optimized/search/segment_boxes.h"
#include "optimized/search/separating_lines.h"

namespace type21::optimized {

namespace {

constexpr float unknown = -1;

}  // namespace

// The box is a rule of its own, in double, with the operations in the order that D34 describes.
/// @manual departure D34
bool ReachBoxRule::holds(const V3& y, const SegmentData& segment, const ContactReach& reach) const {
    if (!on) return true;
    const double outward = std::max(reach.gap, proximity);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (size_t j = 0; j < 4; ++j) {
        const Vec3 corner = axes.transpose() * to_vec3(segment.node[j]);
        const Vec3 normal = axes.transpose() * to_vec3(segment.normal[j]);
        for (const Vec3& end : {Vec3(corner + outward * normal), Vec3(corner - reach.depth * normal)}) {
            low = low.cwiseMin(end);
            high = high.cwiseMax(end);
        }
    }
    const Vec3 growth = 0.01 * (high - low);
    const Vec3 at = axes.transpose() * to_vec3(y);
    return ((low - growth).array() <= at.array()).all() && (at.array() <= (high + growth).array()).all();
}

Search::Search(const Tool& tool, const CaptureLimits& limits, const ReachBoxRule& reach_box, SearchKind kind)
    : tool_(tool),
      limits_(limits),
      growth_(std::max(limits.outward, limits.inward)),
      reach_box_(reach_box),
      usual_clearance_(0),
      usual_radius_(0),
      small_radius_(0),
      neighbour_(kind == SearchKind::tree ? 4 * static_cast<size_t>(tool.size()) : 0),
      leads_(neighbour_.size()) {
    std::vector<Box> boxes = segment_boxes(tool, limits);
    double extent = 0;
    for (const Box& box : boxes)
        extent += largest(box.high - box.low);
    usual_clearance_ = boxes.empty() ? 0 : 16 * extent / static_cast<double>(boxes.size());
    usual_radius_ = usual_clearance_ / 128;
    small_radius_ = usual_radius_ / 16;
    if (kind == SearchKind::tree) {
        tree_ = BoxTree(boxes);
    } else {
        boxes_ = std::move(boxes);
    }
    shift_ = tool.triangles_only() ? 2 : 0;
    LipschitzBounds bounds = lipschitz_bounds(tool, growth_);
    kappa_bits_ = std::move(bounds.kappa_bits);
    margins_ = std::vector<Margins>(bounds.lipschitz.size() >> shift_);
    for (size_t i = 0; i < margins_.size(); ++i) {
        margins_[i].exclusive.store(unknown, std::memory_order_relaxed);
        margins_[i].lipschitz = bounds.lipschitz[i << shift_];
    }
}

size_t Search::bytes() const {
    return tree_.bytes() + margins_.capacity() * sizeof(margins_[0]) + neighbour_.capacity() * sizeof(neighbour_[0]) +
           leads_.capacity() * sizeof(leads_[0]) + kappa_bits_.capacity() + boxes_.capacity() * sizeof(Box);
}

/// @param each  calls its argument with the rank of each segment that competes
template <class EachSegment>
Retained Search::decide_among(const EachSegment& each, const V3& y, const ContactReach& reach,
                              const ProjectionLimits& rules, bool reach_boxes) const {
    Decider decider(y, reach, rules);
    each([&](int s) {
        const SegmentData segment = tool_.segment(s);
        if (reach_boxes && !reach_box_.holds(y, segment, reach)) return;
        decider.add(s, segment);
    });
    return decider.retained([&](int s) { return tool_.segment(s); });
}

Retained Search::search(const V3& y, const ContactReach& reach, const ProjectionLimits& rules, bool reach_boxes) const {
    return decide_among([&](const auto& add) { tree_.at(y, add); }, y, reach, rules, reach_boxes);
}

Retained Search::search(std::span<const int> candidates, const V3& y, const ContactReach& reach,
                        const ProjectionLimits& rules, bool reach_boxes) const {
    const auto each = [&](const auto& add) {
        for (const int s : candidates)
            if (boxes_[static_cast<size_t>(s)].holds(y)) add(s);
    };
    return decide_among(each, y, reach, rules, reach_boxes);
}

Search::Found Search::find(const V3& y, const ContactReach& reach, const ProjectionLimits& rules,
                           Memory& memory) const {
    Found found;
    if (memory.separated_at(y)) {
        found.path = Path::separated;
        return found;
    }
    if (memory.last.exists() && by_exclusive_region(y, reach, rules, memory, found)) return found;
    search_tree(y, reach, rules, memory, found);
    return found;
}

/// Searches the tree, and leaves in memory what the node may use next time.
void Search::search_tree(const V3& y, const ContactReach& reach, const ProjectionLimits& rules, Memory& memory,
                         Found& found) const {
    found.path = Path::searched;
    found.retained = search(y, reach, rules);
    memory.forget();
    if (found.retained.exists()) {
        memory.look_at(found.retained.id);
        use_double_magnitudes(y, reach, found.retained);
        return;
    }
    keep_separated(y, memory);
}

/// Where a plain projection suffices, its numbers are those of the impact, whatever settled the decision. Otherwise the
/// history of a node could show in a last bit.
void Search::use_double_magnitudes(const V3& y, const ContactReach& reach, Retained& retained) const {
    if (reach_box_.on || !retained.exists() || retained.settled == Settled::filter) return;
    ProjectionBatch rows;
    project_one(y, reach, retained.id, rows);
    if (state_in_rows(rows, 0, reach.depth, retained.id) != State::taken) return;
    ProjectionResult& projection = retained.projection;
    projection.b = rows.b[0];
    projection.c = rows.c[0];
    projection.lift = rows.lift[0];
    projection.normal = {rows.n[0][0], rows.n[1][0], rows.n[2][0]};
}

void Search::keep_separated(const V3& y, Memory& memory) const {
    memory.keep_separated(y, clearance(y));
}

bool Search::by_exclusive_region(const V3& y, const ContactReach& reach, const ProjectionLimits& rules, Memory& memory,
                                 Found& found) const {
    const int rank = memory.last.segment(), triangle = memory.last.triangle();
    const SegmentData segment = tool_.segment(rank);
    const FilterResult result = filter(y, segment, local_segment(segment), triangle, reach, rules);
    if (result.verdict != Verdict::taken && result.verdict != Verdict::too_far) return false;
    const ProjectionResult& projection = result.projection;
    float margin = exclusive_margin(memory.last);
    if (margin >= not_a_priori_bounded) margin -= not_a_priori_bounded;
    if (!(projection.least_w >= double(margin))) return false;
    found.path = Path::exclusive_region;
    if (result.verdict == Verdict::too_far) {
        // Proven to lie outside its own reaches; the exclusive region holds between the largest ones.
        if (!(projection.height <= limits_.outward && projection.height >= -limits_.inward)) return false;
        memory.forget();
        return true;
    }
    if (projection.side == 0) return false;
    memory.forget();
    if (!reach_box_.holds(y, segment, reach)) return true;
    found.retained = {memory.last, projection, Settled::filter};
    return true;
}

double Search::clearance(const V3& y) const {
    double clear = usual_clearance_;
    tree_.near(
        y, [&] { return clear; },
        [&](int s, double distance) {
            double least = std::numeric_limits<double>::infinity();
            const SegmentData segment = tool_.segment(s);
            for (int k = 1; k <= segment.sub_triangles(); ++k)
                least = std::min(least, capture_volume(segment, k, limits_).clearance(y));
            clear = std::min(clear, std::max(distance, least));
        });
    return clear;
}

}  // namespace type21::optimized
