#include "optimized/search/search.h"

#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

namespace type21::optimized {

namespace {

constexpr float unknown = -1;
/// Segments whose boxes meet one: beyond this many a core is not worth its set-up.
constexpr size_t most_neighbours = 96;

std::vector<Box> boxes_of(const Tool& tool, const Limits& limits) {
    std::vector<Box> boxes(static_cast<size_t>(tool.size()));
    tbb::parallel_for(tbb::blocked_range<int>(0, tool.size(), 1024), [&](const tbb::blocked_range<int>& range) {
        for (int s = range.begin(); s < range.end(); ++s) {
            const SegmentData segment = tool.segment(s);
            for (int k = 1; k <= segment.pieces(); ++k)
                boxes[static_cast<size_t>(s)].extend(prism(segment, k, limits).box());
        }
    });
    return boxes;
}

}  // namespace

// The box is a rule of its own, in double, with the operations and their order that the departure names.
bool ReachBoxRule::holds(const V3& y, const SegmentData& segment, const Window& window) const {
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
      reach_box_(reach_box),
      usual_clearance_(0),
      core_(4 * static_cast<size_t>(tool.size())) {
    const std::vector<Box> boxes = boxes_of(tool, limits);
    double extent = 0;
    for (const Box& box : boxes)
        extent += largest(box.high - box.low);
    usual_clearance_ = boxes.empty() ? 0 : 16 * extent / static_cast<double>(boxes.size());
    tree_ = BoxTree(boxes);
    for (auto& margin : core_)
        margin.store(unknown, std::memory_order_relaxed);
}

size_t Search::bytes() const {
    return tree_.bytes() + core_.capacity() * sizeof(core_[0]);
}

Retained Search::search(const V3& y, const Window& window, const Rules& rules, bool reach_boxes) const {
    Decider decider(y, window, rules);
    tree_.at(y, [&](int s) {
        const SegmentData segment = tool_.segment(s);
        if (reach_boxes && !reach_box_.holds(y, segment, window)) return;
        decider.add(s, segment);
    });
    return decider.retained([&](int s) { return tool_.segment(s); });
}

Search::Found Search::find(const V3& y, const Window& window, const Rules& rules, Memory& memory) const {
    Found found;
    if (memory.quiet > 0) {
        const V3 way = y - memory.from;
        // A norm of three doubles is right to 3 ulp.
        if (norm(way) * (1 + 1e-14) < double(memory.quiet)) {
            found.path = Path::quiet;
            return found;
        }
    }
    if (memory.segment >= 0 && certified(y, window, rules, memory, found)) return found;
    found.path = Path::searched;
    found.retained = search(y, window, rules);
    if (found.retained.segment >= 0) {
        memory.segment = found.retained.segment;
        memory.piece = found.retained.piece;
        memory.quiet = 0;
        return found;
    }
    const double clear = clearance(y);
    memory.from = y;
    memory.quiet = clear > 0 ? std::nextafter(static_cast<float>(clear), 0.0F) : 0.0F;
    return found;
}

bool Search::certified(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const {
    const SegmentData segment = tool_.segment(memory.segment);
    const FilterResult result = filter(y, segment, local_segment(segment), memory.piece, window, rules);
    if (result.verdict != Verdict::taken && result.verdict != Verdict::beyond) return false;
    const Landing& landing = result.landing;
    const double a = 1 - landing.b - landing.c;
    const double least = std::min(a, std::min(landing.b, landing.c)) - 3 * landing.weight_bound;
    if (!(least >= double(core(memory.segment, memory.piece)))) return false;
    found.path = Path::certified;
    if (result.verdict == Verdict::beyond) {
        // Proven to lie outside its own reaches; the core holds between the largest ones.
        if (!(landing.height <= limits_.outward && landing.height >= -limits_.inward)) return false;
        memory.quiet = 0;
        return true;
    }
    if (landing.side == 0) return false;
    memory.quiet = 0;
    if (!reach_box_.holds(y, segment, window)) return true;
    found.retained = {memory.segment, memory.piece, landing, Settled::filter};
    return true;
}

float Search::core(int segment, int piece) const {
    const size_t at = 4 * static_cast<size_t>(segment) + static_cast<size_t>(piece - 1);
    const float margin = core_[at].load(std::memory_order_relaxed);
    if (margin >= 0) return margin;
    find_cores(segment);
    return core_[at].load(std::memory_order_relaxed);
}

void Search::find_cores(int rank) const {
    const SegmentData segment = tool_.segment(rank);
    std::array<Prism, 4> own;
    std::array<double, 4> margin{};
    Box box;
    const auto pieces = static_cast<size_t>(segment.pieces());
    for (size_t k = 0; k < pieces; ++k) {
        own[k] = prism(segment, static_cast<int>(k) + 1, limits_);
        box.extend(own[k].box());
    }
    size_t neighbours = 0;
    tree_.meeting(box, [&](int other) {
        if (++neighbours > most_neighbours) return;
        const SegmentData facing = tool_.segment(other);
        for (size_t j = 0; j < static_cast<size_t>(facing.pieces()); ++j) {
            const Prism apart = other == rank ? own[j] : prism(facing, static_cast<int>(j) + 1, limits_);
            for (size_t k = 0; k < pieces; ++k) {
                if ((other == rank && j == k) || margin[k] >= 1) continue;
                margin[k] = std::max(margin[k], margin_apart(own[k], apart));
            }
        }
    });
    for (size_t k = 0; k < 4; ++k) {
        const double found = neighbours > most_neighbours ? 1.0 : margin[k];
        core_[4 * static_cast<size_t>(rank) + k].store(std::nextafter(static_cast<float>(found), 2.0F),
                                                       std::memory_order_relaxed);
    }
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
