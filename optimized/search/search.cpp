#include "optimized/search/search.h"

#include <cmath>
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include "optimized/decide/foreseen_bounds.h"

namespace type21::optimized {

namespace {

constexpr float unknown = -1;
/// Added to a core's margin where foreseen() does not hold.
constexpr float beyond_foreseen = 4;
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
    ask_all(y, window, rules, memory, found);
    return found;
}

/// The tree, and what the node may remember of it.
void Search::ask_all(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const {
    found.path = Path::searched;
    found.retained = search(y, window, rules);
    memory.quiet = 0;
    if (found.retained.segment >= 0) {
        memory.segment = found.retained.segment;
        memory.piece = found.retained.piece;
        if (found.retained.settled == Settled::filter) return;
        // Its magnitudes are those that it has where its core is known, or history would show in a last bit.
        const float margin = core(memory.segment, memory.piece);
        if (!(margin < 1)) return;
        const Asked again{y, window, &memory};
        PlainRows rows;
        for (int lane = 0; lane < lanes; ++lane)
            fill_lane(again, lane, rows);
        plain_landing(rows);
        Found plain;
        if (certified_plainly(again, rows, 0, margin, plain)) found.retained.landing = plain.retained.landing;
        return;
    }
    const double clear = clearance(y);
    memory.from = y;
    memory.quiet = clear > 0 ? std::nextafter(static_cast<float>(clear), 0.0F) : 0.0F;
}

void Search::find(const Asked* asked, int count, const Rules& rules, Found* found) const {
    PlainRows rows;
    float margin[lanes];
    bool plain[lanes];
    int filled = -1;
    for (int lane = 0; lane < count; ++lane) {
        const Memory& memory = *asked[lane].memory;
        plain[lane] = false;
        if (memory.segment < 0 || memory.quiet > 0) continue;
        margin[lane] = core(memory.segment, memory.piece);
        plain[lane] = margin[lane] < 1;
        if (plain[lane]) fill_lane(asked[filled = lane], lane, rows);
    }
    if (filled >= 0) {
        // A lane without a question repeats another.
        for (int lane = 0; lane < lanes; ++lane)
            if (lane >= count || !plain[lane]) fill_lane(asked[filled], lane, rows);
        plain_landing(rows);
    }
    for (int lane = 0; lane < count; ++lane) {
        const Asked& one = asked[lane];
        if (plain[lane] && certified_plainly(one, rows, lane, margin[lane], found[lane])) continue;
        found[lane] = find(one.y, one.window, rules, *one.memory);
    }
}

void Search::fill_lane(const Asked& asked, int lane, PlainRows& rows) const {
    using R = PlainRows;
    const int segment = asked.memory->segment, piece = asked.memory->piece;
    const auto put = [&](R::Row row, const V3& v) {
        rows.in[row][lane] = v.x;
        rows.in[row + 1][lane] = v.y;
        rows.in[row + 2][lane] = v.z;
    };
    const bool triangle = tool_.is_triangle(segment);
    const PieceCorners corner = piece_corners(triangle, piece);
    put(R::px, asked.y);
    put(R::ox, tool_.node(segment, triangle ? 2 : 0));
    put(R::x1, tool_.node(segment, 1));
    put(R::x2, tool_.node(segment, 2));
    put(R::x3, tool_.node(segment, 3));
    put(R::bx, tool_.node(segment, corner.b));
    put(R::cx, tool_.node(segment, corner.c));
    put(R::nbx, tool_.normal(segment, corner.b));
    put(R::ncx, tool_.normal(segment, corner.c));
    put(R::l1x, tool_.normal(segment, triangle ? 2 : 0));
    put(R::l2x, triangle ? V3{} : tool_.normal(segment, 1));
    put(R::l3x, triangle ? V3{} : tool_.normal(segment, 2));
    put(R::l4x, triangle ? V3{} : tool_.normal(segment, 3));
    rows.in[R::quarter][lane] = triangle ? 0 : 0.25;
    rows.in[R::normal_quarter][lane] = triangle ? 1 : 0.25;
}

bool Search::certified_plainly(const Asked& asked, const PlainRows& rows, int lane, float core, Found& found) const {
    using R = PlainRows;
    const auto out = [&](R::Result row) { return rows.out[row][lane]; };
    const int segment = asked.memory->segment;
    const double growth = std::max(limits_.outward, limits_.inward);
    const double size = foreseen_size(tool_.extent(segment), growth);
    const double b = out(R::rb), c = out(R::rc), height = out(R::rheight), square = out(R::rsquare);
    const double least = std::min(1 - b - c, std::min(b, c));
    const double rounding = foreseen_share * size;
    // The node is one for which bounds were foreseen, it lies in the core, lands inside without being clipped, and off
    // the plane by more than rounding.
    const double height2 = height * height;
    if (!(out(R::rfar) <= size && std::abs(out(R::rp)) <= 4 && std::abs(out(R::rq)) <= 4 && out(R::rtotal) >= 0.5 &&
          out(R::rinner) >= double(core) + foreseen_share && least >= foreseen_share &&
          height2 > 4 * rounding * rounding * square && height2 * (1 + 1e-9) < growth * growth * square))
        return false;
    const bool front = height > 0;
    if (!(height2 * (1 + 1e-9) <
          (front ? limits_.outward * limits_.outward : limits_.inward * limits_.inward) * square))
        return false;
    const V3 normal{out(R::rnx), out(R::rny), out(R::rnz)};
    const double lift = out(R::rlift);
    const double distance2 = lift * lift * dot(normal, normal);
    // 1: nearer than reach, -1: farther, 0: within rounding.
    const auto nearer = [&](double reach) {
        const double inner = reach - 2 * rounding, outer = reach + 2 * rounding;
        if (inner > 0 && distance2 < inner * inner) return 1;
        return distance2 > outer * outer ? -1 : 0;
    };
    const int touching = nearer(front ? asked.window.gap : asked.window.depth);
    if (touching == 0) return false;
    Kind kind = touching > 0 ? Kind::contact : Kind::none;
    if (touching < 0 && front && asked.window.proximity > 0) {
        const int near = nearer(asked.window.proximity);
        if (near == 0) return false;
        if (near > 0) kind = Kind::proximity;
    }
    found.path = Path::certified;
    found.retained.segment = -1;
    found.retained.settled = Settled::filter;
    if (kind == Kind::none) return true;
    if (reach_box_.on && !reach_box_.holds(asked.y, tool_.segment(segment), asked.window)) return true;
    Landing& landing = found.retained.landing;
    landing.kind = kind;
    landing.side = front ? 1 : -1;
    landing.b = b;
    landing.c = c;
    landing.normal = normal;
    landing.lift = lift;
    found.retained.segment = segment;
    found.retained.piece = asked.memory->piece;
    return true;
}

bool Search::certified(const V3& y, const Window& window, const Rules& rules, Memory& memory, Found& found) const {
    const SegmentData segment = tool_.segment(memory.segment);
    const FilterResult result = filter(y, segment, local_segment(segment), memory.piece, window, rules);
    if (result.verdict != Verdict::taken && result.verdict != Verdict::beyond) return false;
    const Landing& landing = result.landing;
    float margin = core(memory.segment, memory.piece);
    if (margin >= beyond_foreseen) margin -= beyond_foreseen;
    if (!(landing.innermost >= double(margin))) return false;
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
    std::array<Box, 4> own_box;
    std::array<double, 4> margin{};
    Box box;
    const auto pieces = static_cast<size_t>(segment.pieces());
    for (size_t k = 0; k < pieces; ++k) {
        own[k] = prism(segment, static_cast<int>(k) + 1, limits_);
        own_box[k] = own[k].box();
        box.extend(own_box[k]);
    }
    size_t neighbours = 0;
    tree_.meeting(box, [&](int other) {
        if (++neighbours > most_neighbours) return;
        const SegmentData facing = tool_.segment(other);
        for (size_t j = 0; j < static_cast<size_t>(facing.pieces()); ++j) {
            const Prism apart = other == rank ? own[j] : prism(facing, static_cast<int>(j) + 1, limits_);
            const Box apart_box = other == rank ? own_box[j] : apart.box();
            for (size_t k = 0; k < pieces; ++k) {
                if ((other == rank && j == k) || margin[k] >= 1 || !apart_box.meets(own_box[k])) continue;
                margin[k] = std::max(margin[k], margin_apart(own[k], apart));
            }
        }
    });
    for (size_t k = 0; k < 4; ++k) {
        const double found = neighbours > most_neighbours ? 1.0 : margin[k];
        float core = std::nextafter(static_cast<float>(found), 2.0F);
        const double growth = std::max(limits_.outward, limits_.inward);
        if (k < pieces && !foreseen(segment, static_cast<int>(k) + 1, tool_.extent(rank), growth))
            core = std::nextafter(core + beyond_foreseen, 2 * beyond_foreseen);
        core_[4 * static_cast<size_t>(rank) + k].store(core, std::memory_order_relaxed);
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
