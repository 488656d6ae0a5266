#include "optimized/contact.h"

#include <stdexcept>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>

#include "optimized/kernel/adaptive_law.h"
#include "optimized/kernel/contact_point.h"
#include "optimized/kernel/node_data.h"
#include "optimized/kernel/normal_law.h"

namespace type21::optimized {

namespace {

constexpr int chunk = Search::Batch::room;  ///< nodes that one thread takes at a time

/// k of a node, Stfac S between Stmin and Stmax, or Stfac alone.
/// @page field Istf, Stfac, Stmin, Stmax; comment 6, 11; departure D01
double stiffness_of(const Interface& card, double s, const AsBuilt& as_built) {
    if (card.istf == 1) return card.stfac;
    const double k = card.stfac * s;
    if (as_built.has(Departure::D01)) return k;
    return k < card.stmin ? double(card.stmin) : (card.stmax < k ? double(card.stmax) : k);
}

/// C of the tool damping: twice the share of sqrt(inertia times stiffness).
/// @page field Damp, Dampr; comment 19; departure D13
double damping_of_tool(double share, double inertia, double stiffness) {
    return 2.0 * share * std::sqrt(inertia * stiffness);
}

}  // namespace

struct Contact::State {
    State(const Scene& scene, int interface);

    /// Inacti 1, 5, 6: the histories of time 0.
    void start(const Motion& motion);
    /// Gaps of this cycle (Igap 2); a new search when they outgrow the old one's limits.
    void update_gaps(const Motion& motion, ContactStep& step);
    void new_search();
    /// The impact that decides Inacti and the list of initial penetrations; with D31 by another projection.
    struct First {
        double penetration = 0;
        Retained retained;
        ContactPoint point;
    };
    First first_look(size_t i, const Vec3& position, const ToolMotion& pose) const;
    /// Runs the kernel over all nodes.
    void run(const Motion& motion, const Output& out);
    ContactSums sums() const;
    ToolLoad tool_load(const Motion& motion) const;
    bool active(double time) const;
    bool has(Effect effect) const { return scene.has(interface, effect); }

    Scene scene;
    int interface;
    Laws laws;
    NodeData nodes;
    double reach;  ///< that the search holds for [length]
    Kernel one_by_one;
    double least_inertia = 0;  ///< smallest principal inertia of the tool [mass length^2]
    bool started = false;
    int inacti;  ///< as it acts; with D26 it becomes 0 when nothing penetrates at time 0
    std::optional<AdaptiveLaw> adaptive;

    tbb::enumerable_thread_specific<Workspace> work;
    std::vector<ChunkLists> lists;  ///< one a chunk
    StepSums total;
    PathCounts counts;
    LeanStep lean;
    std::vector<Vec3> lean_force;
    std::vector<double> lean_stiffness;
};

Contact::State::State(const Scene& scene_, int interface_)
    : scene(scene_), interface(interface_), laws(scene_, interface_), reach(0), inacti(laws.card->inacti) {
    const Interface& card = *laws.card;
    const SecondarySide& side = card.secondary;
    const size_t n = side.node.size();
    nodes.node = side.node;
    nodes.gap = side.gap;
    if (side.search_gap != side.gap || laws.growth) nodes.search_gap = side.search_gap;
    nodes.mass = side.mass;
    nodes.stiffness.resize(n);
    for (size_t i = 0; i < n; ++i)
        nodes.stiffness[i] = stiffness_of(card, side.element_stiffness[i], laws.model->as_built);
    if (laws.as_built(Departure::D04)) {
        nodes.friction_stiffness = side.element_stiffness;
        if (card.istf == 1) std::fill(nodes.friction_stiffness.begin(), nodes.friction_stiffness.end(), 1.0);
    }
    nodes.offset.assign(n, 0.0);
    nodes.cycles.assign(n, 0);
    nodes.memory.resize(n);
    if (laws.has(effect::friction)) nodes.friction.resize(n);
    if (laws.skid) nodes.skid.assign(n, 0.0);
    if (laws.release) nodes.released.assign(n, 0);
    if (has(Effect::adaptive_data)) adaptive.emplace(*laws.model, card, laws.tool);
    reach = laws.proximity;
    for (size_t i = 0; i < n; ++i)
        reach = std::max(reach, nodes.deciding_gap(i));
    new_search();
    lists.resize((n + chunk - 1) / chunk);
    one_by_one = kernel_for(laws.effects());
    const RigidBody& tool = laws.model->rigid_bodies[static_cast<size_t>(card.tool)];
    if (has(Effect::tool_damping) && card.tool_rotates)
        least_inertia = Eigen::SelfAdjointEigenSolver<Mat3>(tool.inertia).eigenvalues().minCoeff();
}

void Contact::State::new_search() {
    const Interface& card = *laws.card;
    const AsBuilt& as_built = laws.model->as_built;
    ReachBoxRule boxes;
    boxes.on = as_built.has(Departure::D34);
    boxes.proximity = laws.proximity;
    if (boxes.on && card.tool_rotates) {
        const RigidBody& tool = laws.model->rigid_bodies[static_cast<size_t>(card.tool)];
        boxes.axes = Eigen::SelfAdjointEigenSolver<Mat3>(tool.inertia).eigenvectors();
    }
    Limits limits;
    limits.outward = reach;
    limits.inward = card.depth;
    limits.margin = as_built.has(Departure::D31) ? 0.05 : 0.01;
    limits.lift_leaning = as_built.has(Departure::D35);
    laws.search = std::make_unique<Search>(laws.tool, limits, boxes);
    // What nodes remember of the old search holds for the old limits.
    for (Memory& memory : nodes.memory)
        memory.quiet = 0;
}

void Contact::State::update_gaps(const Motion& motion, ContactStep& step) {
    const Interface& card = *laws.card;
    step.smallest_gap_raw = card.smallest_gap_raw;
    step.largest_gap_raw = card.largest_gap;
    if (!laws.growth) return;
    step.smallest_gap_raw = 1e30;
    step.largest_gap_raw = 0;
    double most = 0;
    for (size_t i = 0; i < nodes.gap.size(); ++i) {
        const GrownGap gap = laws.growth->at(static_cast<int>(i), motion.thickness);
        nodes.gap[i] = nodes.search_gap[i] = gap.clipped;
        // D33: the largest gap of time 0 is the least that decides contact.
        if (laws.d33) nodes.search_gap[i] = std::max(std::min(gap.raw, double(card.gapmax)), card.largest_gap);
        most = std::max(most, nodes.search_gap[i]);
        step.smallest_gap_raw = std::min(step.smallest_gap_raw, gap.raw);
        step.largest_gap_raw = std::max(step.largest_gap_raw, gap.raw);
    }
    if (most <= reach) return;
    reach = 1.25 * most;  // room, so that a growing sheet does not ask for a new search every cycle
    new_search();
}

Contact::State::First Contact::State::first_look(size_t i, const Vec3& position, const ToolMotion& pose) const {
    const Interface& card = *laws.card;
    const Vec3 at = pose.rotation.transpose() * (position - pose.position);
    const V3 y = from(at);
    First first;
    if (laws.as_built(Departure::D31)) {
        Rules rules = laws.rules;
        rules.low = -0.05;
        rules.high = 1.05;
        first.retained = laws.search->search(y, {nodes.gap[i], card.depth, 0.0}, rules, false);
        if (first.retained.segment < 0) return first;
        first.point = contact_point_at_start(laws.tool, first.retained, y);
    } else {
        first.retained = laws.search->search(y, {nodes.deciding_gap(i), card.depth, laws.proximity}, laws.rules);
        if (first.retained.segment < 0) return first;
        first.point = laws.d12 ? contact_point_as_built(laws.tool, first.retained, y, position, pose)
                               : contact_point(laws.tool, first.retained, pose);
    }
    first.penetration = penetration_beyond_rounding(nodes.gap[i], first.point.distance, largest(y));
    return first;
}

void Contact::State::start(const Motion& motion) {
    started = true;
    if (motion.time > 0 || (inacti != 1 && inacti != 5 && inacti != 6)) return;
    const ToolMotion& pose = motion.tools[static_cast<size_t>(laws.card->tool)];
    bool any = false;
    for (size_t i = 0; i < nodes.node.size(); ++i) {
        const double p = first_look(i, motion.position[static_cast<size_t>(nodes.node[i])], pose).penetration;
        if (p <= 0) continue;
        any = true;
        nodes.offset[i] = offset_at_start(inacti, p, nodes.gap[i], laws.card->depth);
        if (inacti == 1) nodes.stiffness[i] = 0;
    }
    if (!any && laws.as_built(Departure::D26)) inacti = 0;
}

void Contact::State::run(const Motion& motion, const Output& out) {
    const Cycle cycle(laws, motion, inacti);
    const int count = static_cast<int>(nodes.node.size());
    const bool lanes = in_lanes(laws.effects()) && !cycle.time_zero && laws.proximity == 0;
    const Kernel kernel = lanes ? lanes_kernel : one_by_one;
    for (Workspace& w : work) {
        w.sums.clear();
        w.tally = {};
        w.terms.clear();  // an exception may have left some
    }
    tbb::parallel_for(
        tbb::blocked_range<int>(0, static_cast<int>(lists.size())),
        [&](const tbb::blocked_range<int>& range) {
            Workspace& w = work.local();
            for (int c = range.begin(); c < range.end(); ++c) {
                const int first = c * chunk, last = std::min(first + chunk, count);
                ChunkLists& own = lists[static_cast<size_t>(c)];
                own.clear();
                kernel(laws, cycle, nodes, first, last, out, own, w);
            }
        },
        tbb::static_partitioner());
    total.clear();
    counts.nodes += count;
    for (Workspace& w : work) {
        total.add(w.sums);
        counts.certified += w.tally.certified;
        counts.paired += w.tally.paired;
        counts.quiet += w.tally.quiet;
        counts.searched += w.tally.searched;
        counts.fine += w.tally.fine;
        counts.whole += w.tally.whole;
    }
    if (lanes && !laws.has(effect::friction)) total.without_friction();
}

ContactSums Contact::State::sums() const {
    ContactSums sums;
    sums.normal = total.vector(Term::normal_x);
    sums.tangential = total.vector(Term::tangential_x);
    sums.abs_normal = total.vector(Term::abs_normal_x);
    sums.abs_total = total.vector(Term::abs_total_x);
    sums.signed_normal = total.value(Term::signed_normal);
    sums.norm_total = total.value(Term::norm_total);
    sums.friction_work = total.value(Term::friction_work);
    sums.damping_work = total.value(Term::damping_work);
    sums.elastic_energy = total.value(Term::elastic_energy);
    if (laws.heat) {
        sums.friction_heat = total.value(Term::friction_heat);
        sums.heat_to_blank = total.value(Term::heat_to_blank);
        sums.heat_to_tool = total.value(Term::heat_to_tool);
    }
    return sums;
}

ToolLoad Contact::State::tool_load(const Motion& motion) const {
    const Interface& card = *laws.card;
    ToolLoad load;
    load.force = total.vector(Term::force_x);
    load.moment = total.vector(Term::moment_x);
    load.step_stiffness = total.value(Term::step_stiffness);
    load.step_rotation = total.value(Term::step_rotation);
    if (!has(Effect::tool_damping)) return load;
    // D13: the sums hold C/dt1 as well.
    const bool d13 = laws.as_built(Departure::D13);
    const ToolMotion& pose = motion.tools[static_cast<size_t>(card.tool)];
    ToolMotion other;
    if (card.reference_interface >= 0)
        other =
            motion
                .tools[static_cast<size_t>(laws.model->interfaces[static_cast<size_t>(card.reference_interface)].tool)];
    const RigidBody& tool = laws.model->rigid_bodies[static_cast<size_t>(card.tool)];
    load.damping = damping_of_tool(card.damp, tool.mass, d13 ? load.step_stiffness : total.value(Term::stiffness));
    load.damping_force = -load.damping * (pose.velocity - other.velocity);
    if (card.tool_rotates) {
        load.rotational_damping =
            damping_of_tool(card.dampr, least_inertia, d13 ? load.step_rotation : total.value(Term::rotation));
        load.damping_moment = -load.rotational_damping * (pose.angular_velocity - other.angular_velocity);
    }
    return load;
}

/// The sensor alone where there is one, else the window of time.
/// @page field Tstart, Tstop, sens_ID; comment 20
bool Contact::State::active(double time) const {
    const Interface& card = *laws.card;
    if (card.sensor >= 0) return laws.model->sensors[static_cast<size_t>(card.sensor)].on(time);
    return !(time < card.tstart) && !(time > card.tstop);
}

Contact::Contact(const Scene& scene, int interface) : state_(std::make_unique<State>(scene, interface)) {}

Contact::~Contact() = default;

ContactStep Contact::step(const Motion& motion) {
    ContactStep one;
    step(motion, one);
    return one;
}

void Contact::step(const Motion& motion, ContactStep& step) {
    State& state = *state_;
    // All but the memory is new.
    std::vector<NodeContact> nodes = std::move(step.nodes);
    step = {};
    if (!state.started) state.start(motion);
    step.active = state.active(motion.time);
    if (!step.active) return;
    state.update_gaps(motion, step);
    step.nodes = std::move(nodes);
    step.nodes.resize(state.nodes.node.size());
    state.run(motion, {step.nodes.data(), nullptr, nullptr});
    for (const ChunkLists& own : state.lists) {
        step.released.insert(step.released.end(), own.released.begin(), own.released.end());
        step.inverted.insert(step.inverted.end(), own.inverted.begin(), own.inverted.end());
        step.tool_heat.insert(step.tool_heat.end(), own.tool_heat.begin(), own.tool_heat.end());
    }
    step.sums = state.sums();
    step.tool = state.tool_load(motion);
    if (state.adaptive) step.adaptive = state.adaptive->elements(step.nodes, motion.position);
}

const LeanStep& Contact::step_lean(const Motion& motion) {
    State& state = *state_;
    if (state.laws.heat || state.laws.release || state.laws.normals_test || state.adaptive || state.laws.skid)
        throw std::logic_error("type21: this scene asks for what a lean step does not report; use step()");
    LeanStep& lean = state.lean;
    ContactStep gaps;
    if (!state.started) state.start(motion);
    lean.active = state.active(motion.time);
    lean.force = {};
    lean.step_stiffness = {};
    if (!lean.active) return lean;
    state.update_gaps(motion, gaps);
    state.lean_force.resize(state.nodes.node.size());
    state.lean_stiffness.resize(state.nodes.node.size());
    state.run(motion, {nullptr, state.lean_force.data(), state.lean_stiffness.data()});
    lean.force = state.lean_force;
    lean.step_stiffness = state.lean_stiffness;
    lean.sums = state.sums();
    lean.tool = state.tool_load(motion);
    return lean;
}

Funnel Contact::funnel() const {
    const PathCounts& counts = state_->counts;
    Funnel funnel;
    // Nodes that are not asked (no stiffness, no heat, deleted) are no decisions.
    funnel.nothing_near = counts.quiet;
    funnel.settled = {counts.certified + counts.paired + counts.searched - counts.fine - counts.whole, counts.fine,
                      counts.whole};
    return funnel;
}

std::vector<RoomSize> Contact::rooms() const {
    const State& s = *state_;
    // What the elastic contact holds: gap, stiffness, mass, offset, count, the model's node and the memory of the
    // search.
    std::vector<RoomSize> rooms{{Effect::elastic, 4 * sizeof(double) + 2 * sizeof(int) + sizeof(Memory)}};
    const size_t n = std::max<size_t>(s.nodes.node.size(), 1);
    if (s.laws.growth) rooms.push_back({Effect::gap_growth, sizeof(double) + s.laws.growth->bytes() / n});
    if (s.laws.has(effect::friction))
        rooms.push_back({Effect::friction, sizeof(V3) + s.laws.friction_table.bytes_per_node()});
    if (s.laws.skid) rooms.push_back({Effect::skid_line, sizeof(double)});
    if (s.laws.heat) rooms.push_back({Effect::heat, HeatLaw::bytes_per_node()});
    if (s.laws.release) rooms.push_back({Effect::release_bcs, sizeof(char)});
    if (s.laws.deletion) rooms.push_back({Effect::deletion, s.laws.deletion->bytes() / n});
    return rooms;
}

std::vector<InitialPenetration> Contact::initial_penetrations(const std::vector<Vec3>& positions) const {
    const State& state = *state_;
    ToolMotion pose;
    pose.position = state.laws.model->rigid_bodies[static_cast<size_t>(state.laws.card->tool)].center;
    std::vector<InitialPenetration> found;
    for (size_t i = 0; i < state.nodes.node.size(); ++i) {
        const int node = state.nodes.node[i];
        const State::First first = state.first_look(i, positions[static_cast<size_t>(node)], pose);
        if (first.penetration <= 0) continue;
        found.push_back(
            {node, first.retained.segment, first.penetration, first.point.distance, to_vec3(first.point.normal)});
    }
    return found;
}

PathCounts Contact::paths() const {
    return state_->counts;
}

size_t Contact::tool_bytes() const {
    return state_->laws.tool.bytes() + state_->laws.search->bytes();
}

size_t Contact::bytes_per_node() const {
    size_t bytes = 0;
    for (const RoomSize& room : rooms())
        bytes += room.bytes_per_node;
    return bytes;
}

}  // namespace type21::optimized
