#include <algorithm>
#include <cmath>
#include <tbb/task_arena.h>

#include <fmt/format.h>

#include "reference/contact/contact.h"
#include "reference/contact/tool_surface.h"
#include "verification/bench/bare_step.h"
#include "verification/bench/bench.h"
#include "verification/bench/candidate_list.h"
#include "verification/bench/closest_point.h"
#include "verification/bench/contact_run.h"
#include "verification/bench/plain_search.h"
#include "verification/bench/truth.h"
#include "verification/lockstep/step_difference.h"

namespace type21::bench {

namespace {

const std::string coherent = "optimized, coherent step", whole = "optimized, coherent step with the report",
                  full = "optimized, full search", plain = "plain double, full search",
                  reference_step = "reference, step", embree = "Embree, point query with double callback",
                  cgal = "CGAL AABB tree, closest point in double", epick = "CGAL AABB tree, closest point with EPICK",
                  listed = "candidate list, step", listed_search = "candidate list, search and projection";

/// Set-up, questions and rows of one scene.
class SceneBench {
  public:
    SceneBench(const BenchScene& scene, const BenchOptions& options, BenchResult& result)
        : scene_(scene),
          options_(options),
          effort_(options.quick),
          result_(result),
          run_(set_up()),
          beside_(scene.card(), *scene.scene.model, lockstep_) {}

    void add_product();
    void add_competitors();
    void run();
    GrowthRow growth() const;

  private:
    ContactRun set_up();
    template <class Make>
    auto timed_set_up(const std::string& who, const Make& make);
    /// Times one round of questions of a full search over the next part of the nodes.
    template <class Ask>
    double ask(size_t& start, const Ask& ask);
    void add_row(const std::string& name, const std::string& finds, bool history, long decisions, long wrong,
                 const std::string& note = {});
    void add_ratio(const std::string& what, const std::string& slow, const std::string& fast);
    void judge();
    void judge_closest();
    double way_of_reach() const { return 1.05 * std::max(scene_.card().largest_gap, double(scene_.card().depth)); }
    SurfaceMesh mesh() const;
    bool generated() const { return scene_.kind != "deck"; }

    const BenchScene& scene_;
    const BenchOptions& options_;
    Effort effort_;
    BenchResult& result_;
    SceneRow row_;
    ContactRun run_;
    std::unique_ptr<optimized::Laws> laws_;
    std::vector<optimized::V3> place_;
    std::unique_ptr<PlainSearch> plain_;
    std::unique_ptr<CandidateList> list_;
    std::unique_ptr<ClosestPoint> embree_, cgal_, epick_;
    std::unique_ptr<reference::Contact> reference_;
    std::unique_ptr<optimized::Contact> twin_;  ///< steps beside the reference: how far are the forces apart?
    LockstepResult lockstep_;
    StepDifference beside_;
    double sort_ns_ = 0;
    int list_cycle_ = 0, reference_cycle_ = 0;
    size_t at_[5] = {};
    Rounds rounds_;
};

template <class Make>
auto SceneBench::timed_set_up(const std::string& who, const Make& make) {
    const Watch watch(true);
    auto made = make();
    row_.setup.push_back({who, 1, watch.seconds(), 0, 0});
    return made;
}

ContactRun SceneBench::set_up() {
    row_.scene = scene_.name;
    row_.title = scene_.title;
    row_.kind = scene_.kind;
    row_.segments = scene_.segments().size();
    row_.sub_triangles = scene_.sub_triangles();
    row_.nodes = scene_.nodes();
    row_.gap = scene_.card().largest_gap;
    row_.depth = scene_.card().depth;
    row_.step = scene_.step_length;
    for (const int threads : options_.threads) {
        tbb::task_arena arena(threads);
        arena.execute([&] {
            const Watch watch(threads == 1);
            ContactRun run(scene_);
            row_.setup.push_back(
                {"optimized", threads, watch.seconds(), run.contact().tool_bytes(),
                 static_cast<double>(run.contact().tool_bytes()) / static_cast<double>(row_.segments)});
            row_.bytes_per_node = run.contact().bytes_per_node();
        });
    }
    return ContactRun(scene_);
}

SurfaceMesh SceneBench::mesh() const {
    SurfaceMesh mesh;
    for (int i = 0; i < laws_->tool.size(); ++i)
        mesh.segment.push_back(laws_->tool.corner(i));
    const Interface& card = scene_.card();
    const Model& model = *scene_.scene.model;
    for (const int node : card.main_nodes)
        mesh.node.push_back(model.nodes.position[static_cast<size_t>(node)] -
                            model.rigid_bodies[static_cast<size_t>(card.tool)].center);
    return mesh;
}

template <class Ask>
double SceneBench::ask(size_t& start, const Ask& ask) {
    const size_t count = std::min(place_.size(), static_cast<size_t>(effort_.questions));
    if (start + count > place_.size()) start = 0;
    const Watch watch(true);
    for (size_t i = start; i < start + count; ++i)
        keep(ask(i));
    const double time = watch.nanoseconds() / static_cast<double>(count);
    start += count;
    return time;
}

void SceneBench::add_product() {
    row_.first_cycle = run_.next(true);
    rounds_.add(
        coherent, [&] { return run_.next(true); }, effort_.cycles);
    rounds_.add(whole, [&] { return run_.next(false); });
    laws_ = laws_with_search(scene_.scene, scene_.interface);
    const Motion motion = scene_.motion(0);
    const ToolMotion& pose = motion.tools[static_cast<size_t>(scene_.card().tool)];
    for (const int node : scene_.card().secondary.node)
        place_.push_back(
            optimized::from(pose.rotation.transpose() * (motion.position[static_cast<size_t>(node)] - pose.position)));
    if (!generated()) return;
    const Interface& card = scene_.card();
    rounds_.add(full, [&] {
        return ask(at_[0], [&](size_t i) {
            return laws_->search->search(place_[i], {card.secondary.gap[i], card.depth, 0}, laws_->rules);
        });
    });
    plain_ = std::make_unique<PlainSearch>(laws_->tool, laws_->search->limits());
    rounds_.add(plain, [&] {
        return ask(at_[1], [&](size_t i) { return plain_->at(place_[i], {card.secondary.gap[i], card.depth, 0}); });
    });
}

void SceneBench::add_competitors() {
    const SurfaceMesh surface = mesh();
    const auto closest = [&](const std::string& name, std::unique_ptr<ClosestPoint>& who, size_t& at,
                             const auto& make) {
        who = timed_set_up(name.substr(0, name.find(',')) + (name == epick ? " (EPICK)" : ""), make);
        row_.setup.back().bytes = who->bytes();
        row_.setup.back().bytes_per_segment = static_cast<double>(who->bytes()) / static_cast<double>(row_.segments);
        rounds_.add(name, [&] { return ask(at, [&](size_t i) { return who->at(to_vec3(place_[i])); }); });
    };
    closest(embree, embree_, at_[2], [&] { return closest_by_embree(surface, way_of_reach()); });
    closest(cgal, cgal_, at_[3], [&] { return closest_by_cgal_double(surface); });
    closest(epick, epick_, at_[4], [&] { return closest_by_cgal_epick(surface); });
    reference_ =
        timed_set_up("reference", [&] { return std::make_unique<reference::Contact>(scene_.scene, scene_.interface); });
    twin_ = std::make_unique<optimized::Contact>(scene_.scene, scene_.interface);
    rounds_.add(
        reference_step,
        [&] {
            if (scene_.cycles > 0 && reference_cycle_ >= scene_.cycles) {
                reference_ = std::make_unique<reference::Contact>(scene_.scene, scene_.interface);
                twin_ = std::make_unique<optimized::Contact>(scene_.scene, scene_.interface);
                reference_cycle_ = 0;
            }
            const Motion motion = scene_.motion(reference_cycle_++);
            const Watch watch(true);
            const ContactStep step = reference_->step(motion);
            const double time = watch.nanoseconds() / static_cast<double>(place_.size());
            beside_.add(step, twin_->step(motion), motion, reference_cycle_);
            return time;
        },
        options_.quick ? -3 : -effort_.repeats / 4);
    if (!generated()) return;
    std::vector<std::array<int, 4>> corners = surface.segment;
    const double edge = scene_.card().shortest_edge;
    list_ = timed_set_up("candidate list", [&] {
        return std::make_unique<CandidateList>(surface, reference::nodal_normals(surface.node, corners), scene_.card(),
                                               edge);
    });
    const auto next = [&](bool forces) {
        for (;;) {
            const Motion motion = scene_.motion(list_cycle_++);
            const int sorts = list_->sorts();
            const Watch watch(true);
            forces ? list_->step(motion) : list_->search(motion);
            const double time = watch.nanoseconds() / static_cast<double>(place_.size());
            if (list_->sorts() == sorts) return time + sort_ns_;
        }
    };
    // Sorting is spread over the cycles that it holds for.
    list_->step(scene_.motion(list_cycle_++));
    const Watch watch(true);
    list_->sort();
    sort_ns_ = watch.nanoseconds() / static_cast<double>(place_.size()) / (list_->sizes().margin / scene_.step_length);
    rounds_.add(listed_search, [next] { return next(false); });
    rounds_.add(listed, [next] { return next(true); });
}

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

void SceneBench::run() {
    const optimized::PathCounts before = run_.contact().paths();
    rounds_.run(effort_.repeats);
    const optimized::PathCounts after = run_.contact().paths();
    const double asked = std::max(1.0, static_cast<double>(after.nodes - before.nodes));
    if (after.nodes > before.nodes)
        row_.paths = {{"certified", static_cast<double>(after.certified - before.certified) / asked},
                      {"quiet", static_cast<double>(after.quiet - before.quiet) / asked},
                      {"searched", static_cast<double>(after.searched - before.searched) / asked}};
    judge();
    add_ratio("reference step / coherent step", reference_step, coherent);
    add_ratio("Embree's full search / coherent step", embree, coherent);
    add_ratio("Embree's full search / full search", embree, full);
    add_ratio("CGAL's full search in double / full search", cgal, full);
    add_ratio("candidate list / coherent step with the report", listed, whole);
    add_ratio("candidate list / coherent step", listed, coherent);
    add_ratio("full search / the same in plain double (cost of exactness)", full, plain);
    result_.scenes.push_back(row_);
}

/// Decisions of one cycle against the exact ones.
void SceneBench::judge() {
    const long n = static_cast<long>(place_.size());
    std::vector<Decision> truth;
    std::vector<long> settled(4, 0);
    long step_wrong = 0, full_wrong = 0, plain_wrong = 0, list_wrong = 0, in_contact = 0;
    if (generated()) {
        tbb::task_arena several(options_.threads.back());
        truth = several.execute([&] { return Truth(scene_).at(scene_.motion(0)); });
        // With all that the nodes remember of later places.
        const ContactStep step = run_.contact().step(scene_.motion(0));
        for (size_t i = 0; i < truth.size(); ++i) {
            step_wrong += !same(step.nodes[i].decision, truth[i]);
            in_contact += truth[i].kind == Kind::contact;
        }
        const Interface& card = scene_.card();
        if (list_) list_->search(scene_.motion(0));
        for (size_t i = 0; i < truth.size(); ++i) {
            const optimized::Window window{card.secondary.gap[i], card.depth, 0};
            const optimized::Retained r = laws_->search->search(place_[i], window, laws_->rules);
            Decision decision;
            if (r.segment >= 0) decision = {r.landing.kind, r.segment, r.piece, r.landing.side, 0, 0, Stage::bounded};
            ++settled[static_cast<size_t>(r.settled)];
            full_wrong += !same(decision, truth[i]);
            plain_wrong += !same(plain_->at(place_[i], window), truth[i]);
            if (!list_) continue;
            const CandidateList::Retained& l = list_->retained()[i];
            list_wrong += (l.segment >= 0) != (truth[i].kind == Kind::contact) || l.segment != truth[i].segment ||
                          l.triangle != truth[i].triangle;
        }
        const auto share = [&](size_t i) { return static_cast<double>(settled[i]) / static_cast<double>(n); };
        row_.funnel = {{"filter", share(0)}, {"tie", share(1)}, {"fine", share(2)}, {"whole", share(3)}};
    } else {
        const CheckPart check = check_deck(scene_, 1);
        step_wrong = check.different;
        const ContactStep step = run_.contact().step(scene_.motion(std::max(0, run_.cycle() - 1)));
        for (const NodeContact& node : step.nodes)
            in_contact += node.decision.kind == Kind::contact;
    }
    row_.in_contact = static_cast<double>(in_contact) / static_cast<double>(n);
    add_row(coherent, "impact and forces", true, n, step_wrong,
            run_.has_lean() ? "" : "this scene has no lean step: the whole one");
    add_row(whole, "impact and forces", true, n, step_wrong);
    if (generated()) {
        add_row(full, "impact", false, n, full_wrong);
        add_row(plain, "impact", false, n, plain_wrong);
    }
    if (rounds_.has(reference_step)) add_row(reference_step, "impact and forces", false, n, 0);
    if (embree_) judge_closest();
    if (!list_) return;
    const std::string note = fmt::format("{:.1f} pairs a node; sorting, spread over {:.0f} cycles, is {:.1f} ns of it",
                                         static_cast<double>(list_->pairs()) / static_cast<double>(n),
                                         list_->sizes().margin / scene_.step_length, sort_ns_);
    add_row(listed_search, "impact", true, n, list_wrong, note);
    add_row(listed, "impact and forces", true, n, list_wrong, note);
}

/// The nearest that any of them found is taken for true.
void SceneBench::judge_closest() {
    const size_t n = std::min(place_.size(), static_cast<size_t>(effort_.questions));
    const double reach2 = way_of_reach() * way_of_reach();
    long wrong[3] = {};
    for (size_t i = 0; i < n; ++i) {
        const Vec3 p = to_vec3(place_[i]);
        const double d[3] = {embree_->at(p).distance2, cgal_->at(p).distance2, epick_->at(p).distance2};
        const double least = std::min({d[0], d[1], d[2]});
        // Relative to the coordinates: a distance is a difference of them.
        const double size = p.cwiseAbs().maxCoeff();
        for (size_t j = 0; j < 3; ++j)
            wrong[j] += least <= reach2 && !(std::sqrt(d[j]) <= std::sqrt(least) * (1 + 1e-9) + 1e-14 * size);
    }
    const std::string names[3] = {embree, cgal, epick};
    for (size_t j = 0; j < 3; ++j)
        add_row(names[j], "closest point", false, static_cast<long>(n), wrong[j]);
}

GrowthRow SceneBench::growth() const {
    const auto time = [&](const std::string& name) { return rounds_.has(name) ? rounds_.of(name).p50 : 0.0; };
    return {scene_.name, row_.segments, row_.nodes, time(coherent), time(full), time(embree)};
}

}  // namespace

GrowthRow measure_methods(const BenchScene& scene, const BenchOptions& options, bool competitors, BenchResult& result) {
    tbb::task_arena one(1);
    return one.execute([&] {
        SceneBench bench(scene, options, result);
        bench.add_product();
        if (competitors) bench.add_competitors();
        bench.run();
        return bench.growth();
    });
}

}  // namespace type21::bench
