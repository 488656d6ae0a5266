#include <cmath>
#include <tbb/task_arena.h>

#include <fmt/format.h>

#include "verification/performance/bench/exact_decisions.h"
#include "verification/performance/bench/scene_bench.h"

namespace type21::bench {

using namespace method;

void SceneBench::add_row(const std::string& name, const std::string& finds, bool history, long decisions, long wrong,
                         const std::string& note) {
    const size_t comma = name.find(", ");
    result_.rows.push_back({scene_.name,
                            scene_.kind,
                            name.substr(0, comma),
                            name.substr(comma + 2),
                            finds,
                            history,
                            1,
                            rounds_.of(name),
                            decisions,
                            wrong,
                            {},
                            note});
}

void SceneBench::add_ratio(const std::string& what, const std::string& slow, const std::string& fast) {
    if (!rounds_.has(slow) || !rounds_.has(fast)) return;
    result_.ratios.push_back(
        {scene_.name, what, slow, fast, rounds_.of_medians(slow, fast), rounds_.of_minima(slow, fast)});
}

/// Decisions of one cycle against the exact ones.
void SceneBench::judge() {
    const long n = static_cast<long>(position_.size());
    std::vector<Decision> truth;
    std::array<long, 4> settled{};
    long step_decisions = n, step_wrong = 0, select_wrong = 0, project_wrong = 0, full_wrong = 0, plain_wrong = 0,
         list_wrong = 0, in_contact = 0;
    if (generated()) {
        tbb::task_arena several(options_.threads.back());
        truth = several.execute([&] { return ExactDecisions(scene_).at(scene_.motion(0)); });
        // With what the nodes remember of later positions.
        const ContactStep step = run_.contact().step(scene_.motion(0));
        for (size_t i = 0; i < truth.size(); ++i) {
            step_wrong += !same(step.nodes[i].decision, truth[i]);
            in_contact += truth[i].kind == Kind::contact;
        }
        if (list_) list_->search(scene_.motion(0));
        Motion later = scene_.motion(0);
        later.time = 1;  // time 0 has a way of its own
        select_->bare.step(later, BareStep::Until::select);
        project_->bare.step(later, BareStep::Until::decide);
        const std::vector<Decision> selected = select_->bare.decisions(), projected = project_->bare.decisions();
        FullSearch fresh(*laws_);
        std::vector<Decision> full_found(position_.size()), plain_found(position_.size());
        fresh.at(position_, gaps(), full_found);
        settled = fresh.settled();
        plain_->at(position_, gaps(), scene_.card().depth, plain_found);
        for (size_t i = 0; i < truth.size(); ++i) {
            select_wrong += !same(selected[i], truth[i]);
            project_wrong += !same(projected[i], truth[i]);
            full_wrong += !same(full_found[i], truth[i]);
            plain_wrong += !same(plain_found[i], truth[i]);
            if (!list_) continue;
            const CandidateList::Retained& l = list_->retained()[i];
            list_wrong += (l.segment >= 0) != (truth[i].kind == Kind::contact) || l.segment != truth[i].segment ||
                          l.triangle != truth[i].triangle;
        }
        const auto share = [&](size_t i) { return static_cast<double>(settled[i]) / static_cast<double>(n); };
        row_.stage_counts = {
            {"filter", share(0)}, {"tie", share(1)}, {"double_double", share(2)}, {"integer", share(3)}};
    } else {
        const CheckPart check = check_deck(scene_, 10 * n);
        step_wrong = check.different;
        step_decisions = check.decisions;
        const ContactStep step = run_.contact().step(scene_.motion(std::max(0, run_.cycle() - 1)));
        for (const NodeContact& node : step.nodes)
            in_contact += node.decision.kind == Kind::contact;
    }
    row_.in_contact = static_cast<double>(in_contact) / static_cast<double>(n);
    add_row(coherent, "impact and forces", true, step_decisions, step_wrong,
            run_.has_lean() ? "" : "this scene has no lean step: the full one");
    add_row(with_report, "impact and forces", true, step_decisions, step_wrong);
    if (generated()) {
        add_row(select, "segment", true, n, select_wrong);
        add_row(project, "impact", true, n, project_wrong);
        add_row(full, "impact", false, n, full_wrong);
        add_row(plain, "impact", false, n, plain_wrong);
    }
    if (rounds_.has(reference_step)) add_row(reference_step, "impact and forces", false, n, 0);
    if (cgal_) judge_closest();
    if (!list_) return;
    const std::string note = fmt::format("{:.1f} pairs a node; sorting, spread over {:.0f} cycles, is {:.1f} ns of it",
                                         static_cast<double>(list_->pairs()) / static_cast<double>(n),
                                         list_->sizes().margin / scene_.step_length, sort_ns_);
    add_row(listed_search, "impact", true, n, list_wrong, note);
    add_row(listed, "impact and forces", true, n, list_wrong, note);
}

/// The nearest point that any of them found counts as the right one.
void SceneBench::judge_closest() {
    const size_t n = std::min(position_.size(), static_cast<size_t>(effort_.questions));
    const double reach2 = way_of_reach() * way_of_reach();
    std::vector<std::pair<std::string, const ClosestPoint*>> methods{{cgal, cgal_.get()}, {epick, epick_.get()}};
    if (embree_) methods.insert(methods.begin(), {embree, embree_.get()});
    std::vector<long> wrong(methods.size());
    std::vector<double> d(methods.size());
    for (size_t i = 0; i < n; ++i) {
        const Vec3 p = to_vec3(position_[i]);
        for (size_t j = 0; j < methods.size(); ++j)
            d[j] = methods[j].second->at(p).distance2;
        const double least = *std::min_element(d.begin(), d.end());
        // Relative to the coordinates: a distance is a difference of them.
        const double size = p.cwiseAbs().maxCoeff();
        for (size_t j = 0; j < methods.size(); ++j)
            wrong[j] += least <= reach2 && !(std::sqrt(d[j]) <= std::sqrt(least) * (1 + 1e-9) + 1e-14 * size);
    }
    for (size_t j = 0; j < methods.size(); ++j)
        add_row(methods[j].first, "closest point", false, static_cast<long>(n), wrong[j]);
}

}  // namespace type21::bench
