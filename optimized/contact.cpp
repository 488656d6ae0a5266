#include <atomic>
#include <stdexcept>
#include <string>
#include <tbb/parallel_for.h>

#include "optimized/contact_state.h"

namespace type21::optimized {

namespace {

/// C of the tool damping: twice the share of sqrt(inertia times stiffness).
/// @manual field Damp, Dampr; comment 19; departure D13
double damping_of_tool(double share, double inertia, double stiffness) {
    return 2.0 * share * std::sqrt(inertia * stiffness);
}

/// Adds the count of a chunk; the first node of all is kept.
template <class Notice>
void join(const Notice& chunk, Notice& all) {
    const int count = all.count + chunk.count;
    if (all.count == 0) all = chunk;
    all.count = count;
}

}  // namespace

std::vector<V3> Contact::State::in_tool_frame(std::span<const Vec3> position, const ToolMotion& pose) const {
    std::vector<V3> y(nodes.node.size());
    tbb::parallel_for(tbb::blocked_range<size_t>(0, y.size(), chunk), [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end(); ++i)
            y[i] = in_tool_frame(i, position, pose);
    });
    return y;
}

void Contact::State::keep_lists(const Motion& motion) {
    const ToolMotion& pose = motion.tools[static_cast<size_t>(laws.card->tool)];
    std::atomic<bool> left = candidates->sorts() == 0;
    const auto look = [&](const tbb::blocked_range<size_t>& range) {
        for (size_t i = range.begin(); i < range.end() && !left.load(std::memory_order_relaxed); ++i)
            if (!candidates->covers(i, in_tool_frame(i, motion.position, pose)))
                left.store(true, std::memory_order_relaxed);
    };
    tbb::parallel_for(tbb::blocked_range<size_t>(0, nodes.node.size(), chunk), look);
    ++cycles;
    if (!left) return;
    candidates->sort(in_tool_frame(motion.position, pose));
    ++sorts;
}

void Contact::State::run(const Motion& motion, const Output& out) {
    if (candidates) keep_lists(motion);
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
            w.batch->exclusive_regions = exclusive_region_policy.pays();
            w.batch->lists = candidates ? candidates->all() : nullptr;
            for (int c = range.begin(); c < range.end(); ++c) {
                const int first = c * chunk, last = std::min(first + chunk, count);
                ChunkLists& own = lists[static_cast<size_t>(c)];
                own.clear();
                kernel(laws, cycle, nodes, first, last, out, own, w);
            }
        },
        tbb::static_partitioner());
    total.clear();
    PathTally cycle_paths;
    for (Workspace& w : work) {
        total.add(w.sums);
        cycle_paths.add(w.tally);
    }
    exclusive_region_policy.add(cycle_paths, count, laws.search->slots());
    counts.add(cycle_paths);
    counts.nodes += count;
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

/// About the axis of the spin. D40: the smallest principal one.
/// @manual field Dampr; departure D40
double Contact::State::inertia_of(const Vec3& spin, const ToolMotion& pose) const {
    if (laws.as_built(Departure::D40)) return least_inertia;
    const double size = spin.stableNorm();
    if (!(size > 0)) return 0;
    const Vec3 axis = pose.rotation.transpose() * (spin / size);
    const RigidBody& tool = laws.model->rigid_bodies[static_cast<size_t>(laws.card->tool)];
    return axis.dot(tool.inertia * axis);
}

/// @manual field Damp, Dampr, IDref; comment 19; departure D13
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
        const Vec3 spin = pose.angular_velocity - other.angular_velocity;
        load.rotational_damping =
            damping_of_tool(card.dampr, inertia_of(spin, pose), d13 ? load.step_rotation : total.value(Term::rotation));
        load.damping_moment = -load.rotational_damping * spin;
    }
    return load;
}

/// By the sensor where there is one, else by Tstart and Tstop.
/// @manual field Tstart, Tstop, sens_ID; comment 20
bool Contact::State::active(const Motion& motion) const {
    const Interface& card = *laws.card;
    if (card.sensor < 0) return !(motion.time < card.tstart) && !(motion.time > card.tstop);
    return motion.sensor_on[static_cast<size_t>(card.sensor)];
}

Contact::Contact(const Scene& scene, int interface, const ContactOptions& options)
    : state_(std::make_unique<State>(scene, interface, options)) {}

Contact::~Contact() = default;

ContactStep Contact::step(const Motion& motion) {
    ContactStep one;
    step_into(motion, one);
    return one;
}

void Contact::step_into(const Motion& motion, ContactStep& step) {
    State& state = *state_;
    // All but the memory is new.
    std::vector<NodeContact> nodes = std::move(step.nodes);
    std::vector<NodeHeat> heat = std::move(step.heat);
    std::vector<double> skid = std::move(step.skid);
    step = {};
    if (!state.started) state.start(motion);
    step.active = state.active(motion);
    if (!step.active) return;
    state.update_gaps(motion, step);
    step.nodes = std::move(nodes);
    const size_t count = state.nodes.node.size();
    step.nodes.resize(count);
    Output out;
    out.node = step.nodes.data();
    if (state.laws.heat) {
        step.heat = std::move(heat);
        step.heat.resize(count);
        out.heat = step.heat.data();
    }
    if (state.laws.skid) {
        step.skid = std::move(skid);
        step.skid.resize(count);
        out.skid = step.skid.data();
    }
    state.run(motion, out);
    for (const ChunkLists& own : state.lists) {
        join(own.below_zero, step.friction_below_zero);
        join(own.overflow, step.friction_overflow);
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
        throw std::logic_error("type21: this scene has output that a lean step does not report; use step()");
    LeanStep& lean = state.lean;
    ContactStep gaps;
    if (!state.started) state.start(motion);
    lean.active = state.active(motion);
    lean.force = {};
    lean.step_stiffness = {};
    if (!lean.active) return lean;
    state.update_gaps(motion, gaps);
    state.lean_force.resize(state.nodes.node.size());
    state.lean_stiffness.resize(state.nodes.node.size());
    Output out;
    out.force = state.lean_force.data();
    out.step_stiffness = state.lean_stiffness.data();
    state.run(motion, out);
    lean.force = state.lean_force;
    lean.step_stiffness = state.lean_stiffness;
    lean.sums = state.sums();
    lean.tool = state.tool_load(motion);
    return lean;
}

DecisionStageCounts Contact::decision_stage_counts() const {
    const PathCounts& counts = state_->counts;
    DecisionStageCounts total;
    // Inactive nodes (no stiffness and no heat, or deleted) are no decisions.
    total.nothing_near = counts.separated;
    const long decided = counts.exclusive_region + counts.ranking_safe + counts.edge_neighbour + counts.searched;
    total.settled = {decided - counts.double_double - counts.integer, counts.double_double, counts.integer};
    return total;
}

std::vector<EffectMemory> Contact::memory_by_effect() const {
    const State& s = *state_;
    const size_t n = std::max<size_t>(s.nodes.node.size(), 1);
    // What the elastic contact holds: gap, stiffness, mass, offset, count, the model's node, and the memory or the list
    // of the search.
    const size_t of_search = s.candidates ? s.candidates->bytes() / n : sizeof(Memory);
    std::vector<EffectMemory> memory{
        {Effect::elastic, 4 * sizeof(double) + 2 * sizeof(int) + of_search, sizeof(NodeContact)}};
    if (s.laws.growth) memory.push_back({Effect::gap_growth, sizeof(double) + s.laws.growth->bytes() / n});
    if (s.laws.has(effect::friction))
        memory.push_back({Effect::friction, sizeof(V3) + s.laws.friction_table.bytes_per_node()});
    if (s.laws.skid) memory.push_back({Effect::skid_line, sizeof(double), sizeof(double)});
    if (s.laws.heat) memory.push_back({Effect::heat, HeatLaw::bytes_per_node(), sizeof(NodeHeat)});
    if (s.laws.release) memory.push_back({Effect::release_bcs, sizeof(char)});
    if (s.laws.deletion) memory.push_back({Effect::deletion, s.laws.deletion->bytes() / n});
    return memory;
}

void Contact::save(StateWriter& out) const {
    State::visit(out, *state_);
    NodeData::visit(out, state_->nodes);
}

void Contact::restore(StateReader& in) {
    State& state = *state_;
    const double reach = state.largest_reach;
    State::visit(in, state);
    // A new search makes the nodes forget where to look, so it comes before their memory is read.
    if (state.largest_reach != reach) state.new_search();
    NodeData::visit(in, state.nodes);
}

PathCounts Contact::paths() const {
    return state_->counts;
}

std::optional<SortedSearchCounts> Contact::sorted_search() const {
    const State& s = *state_;
    if (!s.candidates) return std::nullopt;
    SortedSearchCounts counts;
    counts.margin = s.candidates->margin();
    counts.cycles = s.cycles;
    counts.sorts = s.sorts;
    counts.searches = s.counts.searched;
    counts.candidates = s.counts.candidates;
    counts.near = s.counts.near;
    counts.bytes = s.candidates->bytes();
    return counts;
}

size_t Contact::tool_bytes() const {
    return state_->laws.tool.bytes() + state_->laws.search->bytes();
}

size_t Contact::bytes_per_node() const {
    size_t bytes = 0;
    for (const EffectMemory& effect : memory_by_effect())
        bytes += effect.bytes_per_node;
    return bytes;
}

std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface) {
    return make_contact(scene, interface, {});
}

std::unique_ptr<ContactMethod> make_contact(const Scene& scene, int interface, const ContactOptions& options) {
    const size_t count = scene.model->interfaces.size();
    if (interface < 0 || static_cast<size_t>(interface) >= count) {
        throw std::out_of_range("there is no interface " + std::to_string(interface) + ": the model has " +
                                std::to_string(count) + ", counted from 0");
    }
    return std::make_unique<Contact>(scene, interface, options);
}

}  // namespace type21::optimized
