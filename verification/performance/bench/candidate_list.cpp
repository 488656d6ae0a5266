#include "verification/performance/bench/candidate_list.h"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

namespace type21::bench {

namespace {

constexpr double tiny = 1e-30;  ///< the engine's guard of a divisor

/// A sub-triangle with its normals.
struct Piece {
    Vec3 a, b, c, normal_a, normal_b, normal_c;
};

struct Weights {
    double b, c;
    bool outside() const { return b < -0.01 || c < -0.01 || b + c > 1.01; }
};

Weights weights_of(const Vec3& q, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& area) {
    const double under = 1 / std::max(tiny, area.squaredNorm());
    const Vec3 qa = a - q;
    return {-area.dot(qa.cross(c - q)) * under, area.dot(qa.cross(b - q)) * under};
}

double kappa_of(double b, double c) {
    return std::abs(1.0 / 3 - b) + std::abs(1.0 / 3 - c) + std::abs(2.0 / 3 - b - c);
}

Piece piece_of(const SurfaceMesh& tool, const std::vector<Vec3>& normal, int segment, int k) {
    const auto& s = tool.segment[static_cast<size_t>(segment)];
    const auto x = [&](int j) -> const Vec3& { return tool.node[static_cast<size_t>(s[static_cast<size_t>(j)])]; };
    const auto n = [&](int j) -> const Vec3& { return normal[static_cast<size_t>(s[static_cast<size_t>(j)])]; };
    if (s[2] == s[3]) return {x(2), x(0), x(1), n(2), n(0), n(1)};
    return {0.25 * (x(0) + x(1) + x(2) + x(3)), x(k - 1), x(k % 4),
            0.25 * (n(0) + n(1) + n(2) + n(3)), n(k - 1), n(k % 4)};
}

}  // namespace

CandidateList::CandidateList(SurfaceMesh tool, std::vector<Vec3> normal, const Interface& card, double mean_edge)
    : tool_(std::move(tool)),
      normal_(std::move(normal)),
      card_(card),
      sizes_(sort_sizes(card.largest_gap, card.depth, mean_edge)) {
    const size_t n = card.secondary.node.size();
    y_.resize(n);
    retained_.resize(n);
    kappa_.resize(n);
    history_.resize(n);
    force_.resize(n, Vec3::Zero());
    step_stiffness_.resize(n);
    for (size_t i = 0; i < n; ++i)
        stiffness_.push_back(card.istf == 1 ? double(card.stfac) : card.stfac * card.secondary.element_stiffness[i]);
    double farthest = 0;
    for (const Vec3& x : tool_.node) {
        if (x.squaredNorm() <= farthest) continue;
        farthest = x.squaredNorm();
        arm_ = x;
    }
}

void CandidateList::to_tool_frame(const Motion& motion) {
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card_.tool)];
    const Mat3 back = pose.rotation.transpose();
    for (size_t i = 0; i < y_.size(); ++i)
        y_[i] = back * (motion.position[static_cast<size_t>(card_.secondary.node[i])] - pose.position);
}

/// What nodes and tool have moved apart since the list was made, axis by axis, against the margin.
bool CandidateList::must_sort(const Motion& motion) const {
    if (sorted_x_.empty()) return true;
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card_.tool)];
    const Vec3 way = pose.position - sorted_tool_;
    Vec3 most = Vec3::Constant(-1e30), least = Vec3::Constant(1e30);
    for (size_t i = 0; i < y_.size(); ++i) {
        const Vec3 moved = motion.position[static_cast<size_t>(card_.secondary.node[i])] - sorted_x_[i];
        most = most.cwiseMax(moved);
        least = least.cwiseMin(moved);
    }
    const Vec3 apart = (most - way).cwiseMax(way - least).cwiseMax(0.0);
    return sizes_.margin - apart.norm() - (pose.rotation * arm_ - sorted_arm_).norm() <= 0;
}

void CandidateList::sort() {
    pairs_ = sorted_pairs(tool_, y_, sizes_);
    ++sorts_;
}

bool CandidateList::in_box(const Vec3& p, int segment) const {
    Vec3 low = Vec3::Constant(1e30), high = Vec3::Constant(-1e30);
    const auto& s = tool_.segment[static_cast<size_t>(segment)];
    for (const int corner : s) {
        const Vec3& x = tool_.node[static_cast<size_t>(corner)];
        const Vec3& n = normal_[static_cast<size_t>(corner)];
        const Vec3 out = x + sizes_.gap * n, in = x - sizes_.depth * n;
        low = low.cwiseMin(out).cwiseMin(in);
        high = high.cwiseMax(out).cwiseMax(in);
    }
    const Vec3 growth = 0.01 * (high - low);
    return (p.array() >= (low - growth).array()).all() && (p.array() <= (high + growth).array()).all();
}

void CandidateList::project(const CandidatePair& pair) {
    const auto i = static_cast<size_t>(pair.node);
    const Vec3& p = y_[i];
    if (!in_box(p, pair.segment)) return;
    const auto& s = tool_.segment[static_cast<size_t>(pair.segment)];
    const int pieces = s[2] == s[3] ? 1 : 4;
    for (int k = 1; k <= pieces; ++k) {
        const Piece t = piece_of(tool_, normal_, pair.segment, k);
        const Vec3 area = (t.b - t.a).cross(t.c - t.a);
        const double height = (p - t.a).dot(area);
        // The triangle lifted to the node along its normals, and the node's weights there.
        const Vec3 a = t.a + t.normal_a * (height / std::max(tiny, t.normal_a.dot(area)));
        const Vec3 b = t.b + t.normal_b * (height / std::max(tiny, t.normal_b.dot(area)));
        const Vec3 c = t.c + t.normal_c * (height / std::max(tiny, t.normal_c.dot(area)));
        const Vec3 lifted = (b - a).cross(c - a);
        if (lifted.dot(area) <= 0) continue;
        const Weights first = weights_of(p, a, b, c, lifted);
        if (first.outside()) continue;
        // Down again along the normal with those weights.
        const Vec3 n = (1 - first.b - first.c) * t.normal_a + first.b * t.normal_b + first.c * t.normal_c;
        const double slope = n.dot(area);
        if (slope <= 0) continue;
        const Vec3 q = p - n * (height / std::max(tiny, slope));
        const Weights w = weights_of(q, t.a, t.b, t.c, area);
        if (w.outside()) continue;
        const double ca = std::clamp(1 - w.b - w.c, 0.0, 1.0), cb = std::clamp(w.b, 0.0, 1.0),
                     cc = std::clamp(w.c, 0.0, 1.0), sum = std::max(1e-20, ca + cb + cc);
        const Vec3 d = p - (ca * t.a + cb * t.b + cc * t.c) / sum;
        const int side = d.dot(area) >= 0 ? 1 : -1;
        const double limit = side > 0 ? sizes_.gap : sizes_.depth;
        if (!(d.squaredNorm() < limit * limit)) continue;
        const double kappa = kappa_of(w.b, w.c);
        Retained& best = retained_[i];
        const bool better =
            best.segment < 0 || kappa < kappa_[i] || (kappa == kappa_[i] && pair.segment < best.segment);
        if (!better) continue;
        best = {pair.segment, k, side, w.b, w.c};
        kappa_[i] = kappa;
    }
}

void CandidateList::search(const Motion& motion) {
    to_tool_frame(motion);
    if (must_sort(motion)) {
        sort();
        const ToolMotion& pose = motion.tools[static_cast<size_t>(card_.tool)];
        sorted_x_.resize(y_.size());
        for (size_t i = 0; i < y_.size(); ++i)
            sorted_x_[i] = motion.position[static_cast<size_t>(card_.secondary.node[i])];
        sorted_tool_ = pose.position;
        sorted_arm_ = pose.rotation * arm_;
    }
    std::fill(retained_.begin(), retained_.end(), Retained{});
    for (const CandidatePair& pair : pairs_)
        project(pair);
    for (size_t i = 0; i < y_.size(); ++i) {
        if (retained_[i].segment >= 0)
            ++history_[i].cycles;
        else
            history_[i] = {};
    }
}

void CandidateList::step(const Motion& motion) {
    search(motion);
    forces(motion);
}

void CandidateList::forces(const Motion& motion) {
    tool_force_ = tool_moment_ = Vec3::Zero();
    tool_stiffness_ = tool_rotation_ = elastic_energy_ = 0;
    std::fill(force_.begin(), force_.end(), Vec3::Zero());
    std::fill(step_stiffness_.begin(), step_stiffness_.end(), 0.0);
    for (const CandidatePair& pair : pairs_) {
        const auto i = static_cast<size_t>(pair.node);
        if (retained_[i].segment == pair.segment) force_of(i, motion);
    }
}

void CandidateList::force_of(size_t i, const Motion& motion) {
    const Retained& r = retained_[i];
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card_.tool)];
    // Corners and normals in global axes.
    const Piece t = piece_of(tool_, normal_, r.segment, r.triangle);
    const auto at = [&](const Vec3& x) -> Vec3 { return pose.position + pose.rotation * x; };
    const auto turned = [&](const Vec3& n) -> Vec3 { return pose.rotation * n; };
    const double a = 1 - r.b - r.c;
    const Vec3 point = r.b * at(t.b) + r.c * at(t.c) + a * at(t.a);
    const Vec3 outward = r.b * turned(t.normal_b) + r.c * turned(t.normal_c) + a * turned(t.normal_a);
    const auto node = static_cast<size_t>(card_.secondary.node[i]);
    const Vec3 h = motion.position[node] - point;
    const double length = h.norm(), sign = h.dot(outward) >= 0 ? 1.0 : -1.0;
    const Vec3 normal = h * (sign / std::max(1e-20, length));
    const double deep = std::max(0.0, sizes_.gap - sign * length);
    History& history = history_[i];
    const bool start = motion.time <= 0;
    if (deep == 0) {
        if (!start) history = {};
        return;
    }
    if (!start && history.cycles == 1) history.offset = deep;
    history.offset = std::min(history.offset, 0.95 * history.offset + 0.05 * deep);
    const double p = std::max(0.0, deep - history.offset);
    const double k = p == 0 && (history.cycles != 1 || start) ? 0.0 : stiffness_[i];
    const double elastic = k * p;
    elastic_energy_ += 0.5 * k * p * p;

    const Vec3 arm = point - pose.position;
    const Vec3 velocity = motion.velocity[node] - (pose.velocity + pose.angular_velocity.cross(arm));
    const double vn = normal.dot(velocity);
    const double damping = card_.viss * std::sqrt(2 * k * card_.secondary.mass[i]);
    const double pull = -elastic + damping * vn;
    const double by_step = motion.step > 0 ? 1 / motion.step : 0.0;
    damping_work_ += damping * vn * vn * motion.step;

    Vec3 trial = history.friction + stiffness_[i] * motion.friction_step * velocity;
    trial -= trial.dot(normal) * normal;
    const double size = std::sqrt(std::max(tiny, trial.squaredNorm()));
    const Vec3 friction = trial * std::min(1.0, card_.fric * std::abs(pull) / size);
    history.friction = friction;
    friction_work_ += motion.step * velocity.dot(friction);

    const Vec3 on_tool = pull * normal + friction;
    force_[i] = -on_tool;
    step_stiffness_[i] = k + damping * by_step;
    tool_force_ += on_tool;
    tool_moment_ += arm.cross(on_tool);
    tool_stiffness_ += step_stiffness_[i];
    tool_rotation_ += step_stiffness_[i] * arm.squaredNorm();
}

}  // namespace type21::bench
