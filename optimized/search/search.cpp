#include "optimized/search/search.h"

#include <cmath>

#include "optimized/search/segment_boxes.h"
#include "optimized/search/separating_lines.h"

namespace type21::optimized {

namespace {

constexpr float unknown = -1;

}  // namespace

// The box is a rule of its own, in double, with the operations and their order that the departure names.
/// @manual departure D34
bool ReachBoxRule::holds(const V3& y, const SegmentData& segment, const ContactReach& window) const {
    if (!on) return true;
    const double reach = std::max(window.gap, proximity);
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    for (size_t j = 0; j < 4; ++j) {
        const Vec3 corner = axes.transpose() * to_vec3(segment.node[j]);
        const Vec3 normal = axes.transpose() * to_vec3(segment.normal[j]);
        for (const Vec3& end : {Vec3(corner + reach * normal), Vec3(corner - window.depth * normal)}) {
            low = low.cwiseMin(end);
            high = high.cwiseMax(end);
        }
    }
    const Vec3 growth = 0.01 * (high - low);
    const Vec3 at = axes.transpose() * to_vec3(y);
    return ((low - growth).array() <= at.array()).all() && (at.array() <= (high + growth).array()).all();
}

Search::Search(const Tool& tool, const Limits& limits, const ReachBoxRule& reach_box)
    : tool_(tool),
      limits_(limits),
      growth_(std::max(limits.outward, limits.inward)),
      reach_box_(reach_box),
      usual_clearance_(0),
      usual_ball_(0),
      small_ball_(0),
      over_(4 * static_cast<size_t>(tool.size())),
      leads_(4 * static_cast<size_t>(tool.size())) {
    const std::vector<Box> boxes = segment_boxes(tool, limits);
    double extent = 0;
    for (const Box& box : boxes)
        extent += largest(box.high - box.low);
    usual_clearance_ = boxes.empty() ? 0 : 16 * extent / static_cast<double>(boxes.size());
    usual_ball_ = usual_clearance_ / 128;
    small_ball_ = usual_ball_ / 16;
    tree_ = BoxTree(boxes);
    shift_ = tool.triangles_only() ? 2 : 0;
    LipschitzBounds bounds = lipschitz_bounds(tool, growth_);
    kappa_bits_ = std::move(bounds.kappa_bits);
    margins_ = std::vector<Margins>(bounds.rate.size() >> shift_);
    for (size_t i = 0; i < margins_.size(); ++i) {
        margins_[i].alone.store(unknown, std::memory_order_relaxed);
        margins_[i].rate = bounds.rate[i << shift_];
    }
}

size_t Search::bytes() const {
    return tree_.bytes() + margins_.capacity() * sizeof(margins_[0]) + over_.capacity() * sizeof(over_[0]) +
           leads_.capacity() * sizeof(leads_[0]) + kappa_bits_.capacity();
}

Retained Search::search(const V3& y, const ContactReach& window, const ProjectionLimits& rules,
                        bool reach_boxes) const {
    Decider decider(y, window, rules);
    tree_.at(y, [&](int s) {
        const SegmentData segment = tool_.segment(s);
        if (reach_boxes && !reach_box_.holds(y, segment, window)) return;
        decider.add(s, segment);
    });
    return decider.retained([&](int s) { return tool_.segment(s); });
}

Search::Found Search::find(const V3& y, const ContactReach& window, const ProjectionLimits& rules,
                           Memory& memory) const {
    Found found;
    if (memory.quiet_at(y)) {
        found.path = Path::quiet;
        return found;
    }
    if (memory.place >= 0 && certified(y, window, rules, memory, found)) return found;
    ask_all(y, window, rules, memory, found);
    return found;
}

/// The tree, and what the node may remember of it.
void Search::ask_all(const V3& y, const ContactReach& window, const ProjectionLimits& rules, Memory& memory,
                     Found& found) const {
    found.path = Path::searched;
    found.retained = search(y, window, rules);
    memory.forget();
    if (found.retained.segment >= 0) {
        memory.look_at(place_of(found.retained.segment, found.retained.piece));
        use_plain_magnitudes(y, window, found.retained);
        return;
    }
    keep_quiet(y, memory);
}

/// Where a plain projection is known to do, its numbers are those of the impact, whatever settled the decision: or
/// history would show in a last bit.
void Search::use_plain_magnitudes(const V3& y, const ContactReach& window, Retained& retained) const {
    if (reach_box_.on || retained.segment < 0 || retained.settled == Settled::filter) return;
    const int place = place_of(retained.segment, retained.piece);
    ProjectionBatch rows;
    land_one(y, window, place, rows);
    if (standing_in_rows(rows, 0, window.depth, place) != Standing::taken) return;
    ProjectionResult& landing = retained.landing;
    landing.b = rows.b[0];
    landing.c = rows.c[0];
    landing.lift = rows.lift[0];
    landing.normal = {rows.n[0][0], rows.n[1][0], rows.n[2][0]};
}

void Search::keep_quiet(const V3& y, Memory& memory) const {
    memory.keep_quiet(y, clearance(y));
}

bool Search::certified(const V3& y, const ContactReach& window, const ProjectionLimits& rules, Memory& memory,
                       Found& found) const {
    const int rank = segment_of(memory.place), piece = piece_of(memory.place);
    const SegmentData segment = tool_.segment(rank);
    const FilterResult result = filter(y, segment, local_segment(segment), piece, window, rules);
    if (result.verdict != Verdict::taken && result.verdict != Verdict::beyond) return false;
    const ProjectionResult& landing = result.landing;
    float margin = core(memory.place);
    if (margin >= beyond_foreseen) margin -= beyond_foreseen;
    if (!(landing.innermost >= double(margin))) return false;
    found.path = Path::certified;
    if (result.verdict == Verdict::beyond) {
        // Proven to lie outside its own reaches; the core holds between the largest ones.
        if (!(landing.height <= limits_.outward && landing.height >= -limits_.inward)) return false;
        memory.forget();
        return true;
    }
    if (landing.side == 0) return false;
    memory.forget();
    if (!reach_box_.holds(y, segment, window)) return true;
    found.retained = {rank, piece, landing, Settled::filter};
    return true;
}

double Search::clearance(const V3& y) const {
    double clear = usual_clearance_;
    tree_.near(
        y, [&] { return clear; },
        [&](int s, double distance) {
            double least = std::numeric_limits<double>::infinity();
            const SegmentData segment = tool_.segment(s);
            for (int k = 1; k <= segment.pieces(); ++k)
                least = std::min(least, prism(segment, k, limits_).clearance(y));
            clear = std::min(clear, std::max(distance, least));
        });
    return clear;
}

}  // namespace type21::optimized
