#include "optimized/search/separating_lines.h"

#include <algorithm>

namespace type21::optimized {

namespace {

/// Values of a linear function at the three corners.
using Corners = std::array<double, 3>;

/// The smallest m <= 1/2 such that a function that runs from `first` at m = 0 to `last` at m = 1/2 is positive from m
/// on; 1: none.
double positive_from(double first, double last) {
    if (!(last > 0)) return 1;
    return first > 0 ? 0.0 : 0.5 * first / (first - last);
}

/// ... such that it is positive where all weights are >= m.
double positive_inside(const Corners& at) {
    const double middle = (at[0] + at[1] + at[2]) / 3;
    if (!(middle > 0)) return 1;
    const double least = std::min(at[0], std::min(at[1], at[2]));
    // Drawn in to m, a corner has value + 3 m (middle - value).
    return least > 0 ? 0.0 : -least / (3 * (middle - least));
}

/// ... such that it is positive where w_i >= -below and the other two weights are >= m: at the three corners of that
/// triangle, which shrinks to a point or a line.
double positive_along(const Corners& at, size_t i, double below) {
    const double u = at[i], v = at[(i + 1) % 3], w = at[(i + 2) % 3];
    const double tip = positive_from(u, 0.5 * (v + w));
    const double one = positive_from((1 + below) * v - below * u, (0.5 + below) * v + 0.5 * w - below * u);
    const double other = positive_from((1 + below) * w - below * u, (0.5 + below) * w + 0.5 * v - below * u);
    return std::max(tip, std::max(one, other));
}

}  // namespace

SeparatingLines separating_lines(const CaptureVolume& p) {
    SeparatingLines lines;
    lines.slack = p.slack;
    const auto put = [&](const V3& direction, double bound) {
        lines.line[static_cast<size_t>(lines.count++)] = {direction, bound};
    };
    if (p.distance_only) {
        const Box box = p.box();
        put({1, 0, 0}, box.high.x + p.slack);
        put({0, 1, 0}, box.high.y + p.slack);
        put({0, 0, 1}, box.high.z + p.slack);
        put({-1, 0, 0}, p.slack - box.low.x);
        put({0, -1, 0}, p.slack - box.low.y);
        put({0, 0, -1}, p.slack - box.low.z);
        return lines;
    }
    const V3& a = p.corner[0];
    for (size_t i = 0; i < 3; ++i) {
        // max over the corners of rim + h lean is convex in h: below its chord.
        const auto most = [&](double h) {
            return std::max(p.rim[i][0] + h * p.lean[i][0],
                            std::max(p.rim[i][1] + h * p.lean[i][1], p.rim[i][2] + h * p.lean[i][2]));
        };
        const double at_low = most(p.low), at_high = most(p.high);
        const double lean = p.high > p.low ? (at_high - at_low) / (p.high - p.low) : 0.0;
        const V3 direction = p.outward[i] - p.axis * lean;
        put(direction, dot(direction, a) + (at_low - lean * p.low) + p.slack * (1 + std::abs(lean)));
    }
    put(p.axis, dot(p.axis, a) + p.high + p.slack);
    put(p.axis * -1, -dot(p.axis, a) - p.low + p.slack);
    return lines;
}

ExclusiveMargins::ExclusiveMargins(const CaptureVolume& own)
    : distance_only_(own.distance_only), below_(own.margin), slack_(own.slack) {
    if (distance_only_) margin_ = {1, 1, 1, 1};
    for (size_t c = 0; c < 3; ++c) {
        corner_[0][c] = own.corner[c] + own.rise[c] * own.low;
        corner_[1][c] = own.corner[c] + own.rise[c] * own.high;
        middle_ = middle_ + (corner_[0][c] + corner_[1][c]) * (1.0 / 6);
    }
}

/// The direction may be longer than a unit vector, and the slack of a point scales with it.
double ExclusiveMargins::bound_of(const SeparatingLines::Line& line) const {
    return line.bound + slack_ * (std::abs(line.direction.x) + std::abs(line.direction.y) + std::abs(line.direction.z));
}

void ExclusiveMargins::exclude(const SeparatingLines& rival, int side) {
    if (distance_only_) return;
    std::array<double, 4> least{1, 1, 1, 1};
    if (side >= 0) least[static_cast<size_t>(side)] = 0;
    // The line that is farthest from the middle of T first; mostly no other is needed.
    std::array<double, 6> apart;
    for (int l = 0; l < rival.count; ++l) {
        const SeparatingLines::Line& line = rival.line[static_cast<size_t>(l)];
        apart[static_cast<size_t>(l)] = dot(line.direction, middle_) - line.bound;
    }
    for (int tried = 0; tried < rival.count; ++tried) {
        const auto l =
            static_cast<size_t>(std::max_element(apart.begin(), apart.begin() + rival.count) - apart.begin());
        if (!(apart[l] > 0)) break;  // the middle is not beyond it: no margin is large enough
        apart[l] = -1;
        const SeparatingLines::Line& line = rival.line[l];
        const double bound = bound_of(line);
        std::array<Corners, 2> at;
        double lowest = HUGE_VAL;
        for (size_t h = 0; h < 2; ++h) {
            for (size_t c = 0; c < 3; ++c) {
                at[h][c] = dot(line.direction, corner_[h][c]) - bound;
                lowest = std::min(lowest, at[h][c]);
            }
        }
        if (lowest > 0 && below_ * (at[0][0] + at[0][1] + at[0][2] + at[1][0] + at[1][1] + at[1][2]) < lowest)
            return;  // all of T is beyond the line, even drawn out by `below_`
        bool done = true;
        for (size_t q = 0; q < 4; ++q) {
            if (least[q] <= margin_[q]) continue;
            const double one = q == 3 ? std::max(positive_inside(at[0]), positive_inside(at[1]))
                                      : std::max(positive_along(at[0], q, below_), positive_along(at[1], q, below_));
            least[q] = std::min(least[q], one);
            done = done && least[q] <= margin_[q];
        }
        if (done) break;  // this rival needs no larger margin than those before it
    }
    for (size_t q = 0; q < 4; ++q)
        margin_[q] = std::max(margin_[q], least[q]);
}

bool ExclusiveMargins::apart_at(const SeparatingLines& rival, int corner) const {
    if (distance_only_) return false;
    const auto i = static_cast<size_t>(corner);
    const double rest = 1 - lead_weight + below_;
    for (int l = 0; l < rival.count; ++l) {
        const SeparatingLines::Line& line = rival.line[static_cast<size_t>(l)];
        const double bound = bound_of(line);
        double lowest = HUGE_VAL;
        for (size_t h = 0; h < 2; ++h) {
            const auto at = [&](size_t c) { return dot(line.direction, corner_[h][c]) - bound; };
            const double u = at(i), v = at((i + 1) % 3), w = at((i + 2) % 3);
            // The corners of that part.
            lowest = std::min(lowest, (1 + 2 * below_) * u - below_ * (v + w));
            lowest = std::min(lowest, lead_weight * u - below_ * v + rest * w);
            lowest = std::min(lowest, lead_weight * u - below_ * w + rest * v);
        }
        if (lowest > 0) return true;
    }
    return false;
}

}  // namespace type21::optimized
