#include "verification/performance/bench/scene_bench.h"

#include <tbb/task_arena.h>

#include "reference/contact/tool_surface.h"

namespace type21::bench {

using namespace method;

template <class Make>
auto SceneBench::timed_set_up(const std::string& method, const Make& make) {
    const Watch watch(true);
    auto made = make();
    row_.setup.push_back({method, 1, watch.seconds(), 0, 0});
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
    const Model& model = *scene_.scene.host;
    for (const int node : card.main_nodes)
        mesh.node.push_back(model.nodes.position[static_cast<size_t>(node)] -
                            model.rigid_bodies[static_cast<size_t>(card.tool)].center);
    return mesh;
}

template <class Decide>
double SceneBench::time_part(size_t& start, const Decide& decide_all) {
    const size_t count = std::min(position_.size(), static_cast<size_t>(effort_.questions));
    if (start + count > position_.size()) start = 0;
    const Watch watch(true);
    decide_all(start, count);
    const double time = watch.nanoseconds() / static_cast<double>(count);
    start += count;
    return time;
}

template <class Decide>
double SceneBench::time_each(size_t& start, const Decide& decide) {
    return time_part(start, [&](size_t first, size_t count) {
        for (size_t i = first; i < first + count; ++i)
            keep(decide(i));
    });
}

void SceneBench::add_product() {
    row_.first_cycle = run_.next(true);
    run_.settle();
    rounds_.add(
        coherent, [&] { return run_.next(true); }, effort_.cycles);
    rounds_.add(with_report, [&] { return run_.next(false); });
    laws_ = laws_with_search(scene_.scene, scene_.interface);
    const Motion motion = scene_.motion(0);
    const ToolMotion& pose = motion.tools[static_cast<size_t>(scene_.card().tool)];
    for (const int node : scene_.card().secondary.node)
        position_.push_back(
            optimized::from(pose.rotation.transpose() * (motion.position[static_cast<size_t>(node)] - pose.position)));
    if (!generated()) return;
    // Steps that stop when the retained sub-triangles are known, and when the contact points are.
    select_ = std::make_unique<BareRun>(scene_, true, BareStep::Until::select);
    project_ = std::make_unique<BareRun>(scene_, true, BareStep::Until::decide);
    select_->settle();
    project_->settle();
    rounds_.add(
        select, [&] { return select_->next(); }, effort_.cycles);
    rounds_.add(
        project, [&] { return project_->next(); }, effort_.cycles);
    found_.resize(position_.size());
    const std::span<const optimized::V3> position(position_);
    const std::span<Decision> found(found_);
    full_ = std::make_unique<FullSearch>(*laws_);
    rounds_.add(full, [this, position, found] {
        return time_part(at_[0], [&](size_t first, size_t count) {
            full_->at(position.subspan(first, count), gaps().subspan(first, count), found.subspan(first, count));
            keep(found_);
        });
    });
    plain_ = std::make_unique<PlainSearch>(laws_->tool, laws_->search->limits());
    rounds_.add(plain, [this, position, found] {
        return time_part(at_[1], [&](size_t first, size_t count) {
            plain_->at(position.subspan(first, count), gaps().subspan(first, count), scene_.card().depth,
                       found.subspan(first, count));
            keep(found_);
        });
    });
}

void SceneBench::add_competitors() {
    const SurfaceMesh surface = mesh();
    const auto closest = [&](const std::string& name, std::unique_ptr<ClosestPoint>& method, size_t& at,
                             const auto& make) {
        method = timed_set_up(name.substr(0, name.find(',')) + (name == epick ? " (EPICK)" : ""), make);
        row_.setup.back().bytes = method->bytes();
        row_.setup.back().bytes_per_segment = static_cast<double>(method->bytes()) / static_cast<double>(row_.segments);
        rounds_.add(name, [&] { return time_each(at, [&](size_t i) { return method->at(to_vec3(position_[i])); }); });
    };
    if (has_embree()) closest(embree, embree_, at_[2], [&] { return closest_by_embree(surface, way_of_reach()); });
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
            const double time = watch.nanoseconds() / static_cast<double>(position_.size());
            beside_.add(step, twin_->step(motion), motion, reference_cycle_);
            return time;
        },
        options_.quick && generated() ? -effort_.repeats : -effort_.repeats / 4);
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
            const double time = watch.nanoseconds() / static_cast<double>(position_.size());
            if (list_->sorts() == sorts) return time + sort_ns_;
        }
    };
    // Sorting is spread over the cycles that it holds for.
    list_->step(scene_.motion(list_cycle_++));
    const Watch watch(true);
    list_->sort();
    sort_ns_ =
        watch.nanoseconds() / static_cast<double>(position_.size()) / (list_->sizes().margin / scene_.step_length);
    rounds_.add(listed_search, [next] { return next(false); });
    rounds_.add(listed, [next] { return next(true); });
}

void SceneBench::run() {
    const optimized::PathCounts before = run_.contact().paths();
    row_.repeats = rounds_.run(effort_.repeats, effort_.seconds);
    const optimized::PathCounts after = run_.contact().paths();
    const double nodes = std::max(1.0, static_cast<double>(after.nodes - before.nodes));
    if (after.nodes > before.nodes)
        row_.paths = {
            {"exclusive_region", static_cast<double>(after.exclusive_region - before.exclusive_region) / nodes},
            {"ranking_safe", static_cast<double>(after.ranking_safe - before.ranking_safe) / nodes},
            {"edge_neighbour", static_cast<double>(after.edge_neighbour - before.edge_neighbour) / nodes},
            {"separated", static_cast<double>(after.separated - before.separated) / nodes},
            {"searched", static_cast<double>(after.searched - before.searched) / nodes}};
    judge();
    add_ratio("reference step / coherent step", reference_step, coherent);
    add_ratio("Embree's full search / coherent selection", embree, select);
    add_ratio("Embree's full search / coherent selection and projection", embree, project);
    add_ratio("Embree's full search / coherent step", embree, coherent);
    add_ratio("Embree's full search / full search", embree, full);
    add_ratio("CGAL's full search in double / full search", cgal, full);
    add_ratio("candidate list / coherent step with the report", listed, with_report);
    add_ratio("candidate list / coherent step", listed, coherent);
    add_ratio("full search / the same in plain double (cost of exactness)", full, plain);
    result_.scenes.push_back(row_);
}

GrowthRow SceneBench::growth() const {
    GrowthRow row{scene_.name, row_.segments, row_.nodes, rounds_.of(coherent).p50, rounds_.of(full).p50, {}};
    if (rounds_.has(embree)) row.embree = rounds_.of(embree).p50;
    return row;
}

std::optional<GrowthRow> measure_methods(const BenchScene& scene, const BenchOptions& options, bool competitors,
                                         BenchResult& result) {
    tbb::task_arena one(1);
    return one.execute([&]() -> std::optional<GrowthRow> {
        SceneBench bench(scene, options, result);
        bench.add_product();
        if (competitors) bench.add_competitors();
        bench.run();
        if (scene.kind == "deck") return std::nullopt;  // has no full search
        return bench.growth();
    });
}

}  // namespace type21::bench
