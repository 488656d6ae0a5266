#include "verification/bench/bare_step.h"

#include <algorithm>
#include <cmath>

#include "optimized/kernel/contact_point.h"
#include "optimized/kernel/normal_law.h"
#include "verification/bench/timing.h"

namespace type21::bench {

using optimized::Search;
using optimized::Term;
using optimized::TermBlock;
using optimized::V3;

std::unique_ptr<optimized::Laws> laws_with_search(const Scene& scene, int interface) {
    auto laws = std::make_unique<optimized::Laws>(scene, interface);
    optimized::Limits limits;
    limits.outward = laws->proximity;
    for (const double gap : laws->card->secondary.search_gap)
        limits.outward = std::max(limits.outward, gap);
    limits.inward = laws->card->depth;
    laws->search = std::make_unique<Search>(laws->tool, limits, optimized::ReachBoxRule());
    return laws;
}

BareStep::BareStep(const BenchScene& scene, bool rubbing)
    : rubbing_(rubbing),
      laws_(laws_with_search(scene.scene, scene.interface)),
      work_(std::make_unique<optimized::Workspace>()) {
    const SecondarySide& side = laws_->card->secondary;
    const size_t n = side.node.size();
    nodes_.node = side.node;
    nodes_.gap = side.gap;
    nodes_.mass = side.mass;
    nodes_.stiffness.assign(n, laws_->card->stfac);
    nodes_.offset.assign(n, 0.0);
    nodes_.cycles.assign(n, 0);
    nodes_.memory.resize(n);
    nodes_.friction.resize(n);
    place_.resize(n);
    force_.resize(n);
    step_stiffness_.resize(n);
}

namespace {

/// Rows of the sums that the scene fills, in the order of Term.
constexpr int rows = static_cast<int>(Term::friction_heat);

struct Closed {
    double elastic_energy, damping, normal_force, step_stiffness, stiffness;
    V3 normal, velocity, friction, force, arm;
};

/// @param put  takes a Term and its number
template <class Put>
void each_term(const Closed& n, double step, const Put& put) {
    const auto put_vector = [&](Term first, const V3& v) {
        put(first, v.x);
        put(static_cast<Term>(static_cast<int>(first) + 1), v.y);
        put(static_cast<Term>(static_cast<int>(first) + 2), v.z);
    };
    const auto magnitudes = [](const V3& v) { return V3{std::abs(v.x), std::abs(v.y), std::abs(v.z)}; };
    const V3 normal = n.normal * -n.normal_force, total = normal + n.friction, on_tool = n.force * -1;
    const double vn = dot(n.velocity, n.normal), square = dot(n.arm, n.arm);
    put_vector(Term::normal_x, normal);
    put_vector(Term::tangential_x, n.friction);
    put_vector(Term::abs_normal_x, magnitudes(normal));
    put_vector(Term::abs_total_x, magnitudes(total));
    put(Term::signed_normal, -n.normal_force);
    put(Term::norm_total, norm(total));
    put(Term::friction_work, step * dot(n.velocity, n.friction));
    put(Term::damping_work, n.damping * vn * vn * step);
    put(Term::elastic_energy, n.elastic_energy);
    put_vector(Term::force_x, on_tool);
    put_vector(Term::moment_x, cross(n.arm, on_tool));
    put(Term::stiffness, n.stiffness);
    put(Term::rotation, n.stiffness * square);
    put(Term::step_stiffness, n.step_stiffness);
    put(Term::step_rotation, n.step_stiffness * square);
}

}  // namespace

template <bool rubbing, BareStep::Until until, BareStep::Sums how>
void BareStep::run(const Motion& motion) {
    constexpr int lanes = optimized::lanes;
    const Interface& card = *laws_->card;
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card.tool)];
    const bool time_zero = motion.time <= 0;
    const double alpha = rubbing ? optimized::filter_share(card, motion.friction_step, laws_->model->as_built) : 0;
    const int count = static_cast<int>(nodes_.node.size());
    std::array<double, static_cast<size_t>(rows)> plain{};
    TermBlock& terms = work_->terms;
    terms.clear();
    work_->sums.clear();
    tally_ = {};
    searched_.clear();
    const auto flush = [&] {
        work_->sums.add(terms, rows);
        terms.clear();
    };
    Search::Asked asked[lanes];
    Search::Found found[lanes];
    for (int start = 0; start < count; start += lanes) {
        const int some = std::min(lanes, count - start);
        for (int j = 0; j < some; ++j) {
            const auto i = static_cast<size_t>(start + j);
            const Vec3& position = motion.position[static_cast<size_t>(nodes_.node[i])];
            const Vec3 at = pose.rotation.transpose() * (position - pose.position);
            place_[i] = optimized::from(at);
            asked[j] = {place_[i], window(i), &nodes_.memory[i]};
        }
        if constexpr (until == Until::transform) continue;
        laws_->search->find(asked, some, laws_->rules, found);
        for (int j = 0; j < some; ++j) {
            tally_.certified += found[j].path == optimized::Path::certified;
            tally_.quiet += found[j].path == optimized::Path::quiet;
            tally_.searched += found[j].path == optimized::Path::searched;
            if (found[j].path == optimized::Path::searched) searched_.push_back(start + j);
        }
        keep(found);
        if constexpr (until == Until::decide) continue;
        for (int j = 0; j < some; ++j) {
            const auto i = static_cast<size_t>(start + j);
            const optimized::Retained& retained = found[j].retained;
            force_[i] = Vec3::Zero();
            step_stiffness_[i] = 0;
            const auto forget = [&] {
                if (time_zero) return;
                nodes_.offset[i] = 0;
                nodes_.cycles[i] = 0;
                if constexpr (rubbing) nodes_.friction[i] = {};
            };
            if (retained.segment < 0) {
                forget();
                continue;
            }
            const optimized::ContactPoint point = contact_point(laws_->tool, retained, pose);
            const double deep =
                optimized::penetration_beyond_rounding(nodes_.gap[i], point.distance, largest(place_[i]));
            if (deep == 0) {
                forget();
                continue;
            }
            ++nodes_.cycles[i];
            const bool first = nodes_.cycles[i] == 1;
            double offset = first && !time_zero ? deep : nodes_.offset[i];
            offset = optimized::offset_after(offset, false, deep, nodes_.gap[i]);
            nodes_.offset[i] = offset;
            const double p = std::max(deep - offset, 0.0);
            const bool acts = p > 0 || first;
            Closed n;
            n.stiffness = acts ? nodes_.stiffness[i] : 0.0;
            n.normal = point.normal;
            n.arm = point.point - optimized::from(pose.position);
            n.velocity = optimized::from(motion.velocity[static_cast<size_t>(nodes_.node[i])]) -
                         (optimized::from(pose.velocity) + cross(optimized::from(pose.angular_velocity), n.arm));
            const optimized::Spring spring = optimized::linear_spring(n.stiffness, p);
            n.elastic_energy = spring.energy;
            n.damping = rubbing ? card.viss * std::sqrt(2 * n.stiffness * nodes_.mass[i]) : 0.0;
            n.normal_force = spring.force - n.damping * dot(n.velocity, n.normal);
            n.step_stiffness = motion.step > 0 ? n.stiffness + n.damping / motion.step : n.stiffness;
            n.friction = {};
            if constexpr (rubbing) {
                const double growth = alpha * (acts ? nodes_.stiffness[i] : 0.0) * motion.friction_step;
                const optimized::Tangential t = optimized::returned_to_limit(
                    nodes_.friction[i], n.velocity, growth, n.normal, card.fric * std::abs(n.normal_force));
                n.friction = nodes_.friction[i] = t.force;
            }
            n.force = n.normal * n.normal_force - n.friction;
            force_[i] = to_vec3(n.force);
            step_stiffness_[i] = n.step_stiffness;
            if constexpr (until == Until::force) continue;
            if constexpr (how == Sums::plain) {
                each_term(n, motion.step, [&](Term term, double value) { plain[static_cast<size_t>(term)] += value; });
            } else {
                double* column = terms.column();
                each_term(n, motion.step,
                          [&](Term term, double value) { column[static_cast<int>(term) * TermBlock::stride] = value; });
                terms.next();
                if (terms.size() == TermBlock::room) flush();
            }
        }
    }
    if constexpr (until == Until::sum) {
        if (terms.size() > 0) flush();
        const auto at = static_cast<size_t>(Term::force_x);
        tool_force_ =
            how == Sums::exact ? work_->sums.vector(Term::force_x) : Vec3(plain[at], plain[at + 1], plain[at + 2]);
    }
}

template <bool rubbing>
void BareStep::dispatch(const Motion& motion, Until until, Sums sums) {
    if (until == Until::transform) return run<rubbing, Until::transform, Sums::exact>(motion);
    if (until == Until::decide) return run<rubbing, Until::decide, Sums::exact>(motion);
    if (until == Until::force) return run<rubbing, Until::force, Sums::exact>(motion);
    if (sums == Sums::plain) return run<rubbing, Until::sum, Sums::plain>(motion);
    run<rubbing, Until::sum, Sums::exact>(motion);
}

void BareStep::step(const Motion& motion, Until until, Sums sums) {
    if (rubbing_)
        dispatch<true>(motion, until, sums);
    else
        dispatch<false>(motion, until, sums);
}

}  // namespace type21::bench
