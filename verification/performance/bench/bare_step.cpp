#include "verification/performance/bench/bare_step.h"

#include <algorithm>
#include <cstring>

#include "optimized/kernel/force_rows.h"
#include "verification/performance/bench/timing.h"

namespace type21::bench {

using optimized::fetch;
using optimized::ForceRows;
using optimized::into_rows;
using optimized::Search;
using optimized::Term;
using optimized::TermBlock;

std::unique_ptr<optimized::Laws> laws_with_search(const Scene& scene, int interface) {
    auto laws = std::make_unique<optimized::Laws>(scene, interface);
    optimized::CaptureLimits limits;
    limits.outward = laws->proximity;
    for (const double gap : laws->card->secondary.search_gap)
        limits.outward = std::max(limits.outward, gap);
    limits.inward = laws->card->depth;
    laws->search = std::make_unique<Search>(laws->tool, limits, optimized::ReachBoxRule());
    return laws;
}

BareStep::BareStep(const BenchScene& scene, bool with_friction)
    : with_friction_(with_friction),
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
    if (with_friction_) nodes_.friction.resize(n);
    position_.resize(n);
    retained_.assign(n, optimized::SubTriangleId::none());
    side_.resize(n);
    force_.resize(n);
    step_stiffness_.resize(n);
}

std::vector<Decision> BareStep::decisions() const {
    std::vector<Decision> all(retained_.size());
    for (size_t i = 0; i < all.size(); ++i) {
        if (!retained_[i].exists()) continue;
        all[i].kind = Kind::contact;  // there is no proximity here
        all[i].segment = retained_[i].segment();
        all[i].triangle = retained_[i].triangle();
        all[i].side = side_[i];
    }
    return all;
}

/// Time 0 has rules of its own. The product's node-by-node kernel has them.
void BareStep::at_time_zero(const optimized::Cycle& cycle) {
    const int count = static_cast<int>(nodes_.node.size());
    optimized::ChunkLists lists;
    optimized::Output output;
    output.force = force_.data();
    output.step_stiffness = step_stiffness_.data();
    work_->sums.clear();
    optimized::kernel_for(laws_->effects())(*laws_, cycle, nodes_, 0, count, output, lists, *work_);
    tool_force_ = work_->sums.vector(Term::force_x);
}

template <bool with_friction, BareStep::Until until, BareStep::Sums how>
void BareStep::run(const Motion& motion) {
    const optimized::Cycle cycle(*laws_, motion, laws_->card->inacti);
    if (cycles_++ > 0)
        exclusive_region_policy_.add(tally_, static_cast<long>(nodes_.node.size()), laws_->search->slots());
    work_->batch->exclusive_regions = exclusive_region_policy_.pays();
    tally_ = {};
    searched_.clear();
    edge_neighbour_.clear();
    if (cycle.time_zero) return at_time_zero(cycle);
    const optimized::ForceCycle shared(*laws_, cycle);
    const optimized::Forces forces =
        optimized::forces_for(with_friction ? optimized::effect::damping | optimized::effect::friction : 0);
    const std::span<const Term> summed = laws_->terms();
    std::array<double, static_cast<size_t>(Term::count)> plain{};
    Search::Batch& batch = *work_->batch;
    ForceRows& f = *work_->forces;
    TermBlock& terms = work_->terms;
    terms.clear();
    work_->sums.clear();
    batch.depth = laws_->card->depth;
    batch.proximity = 0;
    const int last = static_cast<int>(nodes_.node.size());
    f.full_report = false;
    optimized::Prefetcher prefetcher = optimized::prefetched_by_search(nodes_, motion);
    if (until == Until::force || until == Until::sum)
        optimized::add_forces(nodes_, motion, force_.data(), step_stiffness_.data(), prefetcher);
    batch.prefetcher = &prefetcher;
    for (int first = 0; first < last; first += Search::Batch::capacity) {
        batch.count = std::min(Search::Batch::capacity, last - first);
        batch.first = first;
        batch.memory = nodes_.memory.data() + first;
        std::fill_n(batch.active, batch.count, true);
        into_rows(motion.position, nodes_.node.data() + first, batch.count, batch.y);
        fetch(nodes_.gap, first, batch.count, batch.gap);
        to_tool_frame(batch, batch.count, shared);
        keep(batch);
        if constexpr (until == Until::transform) continue;
        if constexpr (until == Until::select)
            laws_->search->select(batch, laws_->rules);
        else
            laws_->search->find(batch, laws_->rules);
        tally_.add(batch.tally);
        if constexpr (until == Until::select || until == Until::decide) {
            std::copy_n(batch.id, batch.count, retained_.data() + first);
            std::memcpy(side_.data() + first, batch.side, static_cast<size_t>(batch.count));
            continue;
        }
        if constexpr (until == Until::look) {
            for (int j = 0; j < batch.count; ++j) {
                position_[static_cast<size_t>(first + j)] = {batch.y[0][j], batch.y[1][j], batch.y[2][j]};
                if (batch.path[j] == optimized::Path::searched) searched_.push_back(first + j);
                if (batch.path[j] == optimized::Path::edge_neighbour) edge_neighbour_.push_back(first + j);
            }
            continue;
        }
        for (int at = 0; at < batch.count; at += ForceRows::capacity) {
            const int start = first + at;
            const bool acts = f.prepare(nodes_, start, batch, at, motion.velocity, with_friction, with_friction);
            if (acts) forces(shared, batch, f, terms);
            f.store_history(nodes_, acts);
            f.store_forces(acts, force_.data(), step_stiffness_.data());
            if (!acts) continue;
            if constexpr (until == Until::force) continue;
            if constexpr (how == Sums::plain) {
                for (const Term term : summed) {
                    const double* row = terms.row(term);
                    double sum = 0;
                    for (int j = 0; j < terms.size(); ++j)
                        sum += row[j];
                    plain[static_cast<size_t>(term)] += sum;
                }
            } else {
                work_->sums.add(terms, summed);
            }
            terms.clear();
        }
    }
    if constexpr (until == Until::sum) {
        // Without friction the force is the normal force, and only that is summed.
        const Term of_force = with_friction ? Term::force_x : Term::normal_x;
        const auto at = static_cast<size_t>(of_force);
        tool_force_ = how == Sums::exact ? work_->sums.vector(of_force) : Vec3(plain[at], plain[at + 1], plain[at + 2]);
    }
}

template <bool with_friction>
void BareStep::dispatch(const Motion& motion, Until until, Sums sums) {
    if (until == Until::transform) return run<with_friction, Until::transform, Sums::exact>(motion);
    if (until == Until::select) return run<with_friction, Until::select, Sums::exact>(motion);
    if (until == Until::decide) return run<with_friction, Until::decide, Sums::exact>(motion);
    if (until == Until::look) return run<with_friction, Until::look, Sums::exact>(motion);
    if (until == Until::force) return run<with_friction, Until::force, Sums::exact>(motion);
    if (sums == Sums::plain) return run<with_friction, Until::sum, Sums::plain>(motion);
    run<with_friction, Until::sum, Sums::exact>(motion);
}

void BareStep::step(const Motion& motion, Until until, Sums sums) {
    if (with_friction_)
        dispatch<true>(motion, until, sums);
    else
        dispatch<false>(motion, until, sums);
}

}  // namespace type21::bench
