#include "reference/host/conditions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

#include "reference/host/finite_check.h"
#include "reference/host/step_watch.h"
#include "reference/model/motion_keyword.h"

namespace type21 {

namespace {

/// Ids of the nodes in a list, the first few written out.
class NodeList {
  public:
    void add(Id id) {
        if (count_++ < 5) text_ += fmt::format("{}{}", text_.empty() ? "" : ", ", id);
    }
    int count() const { return count_; }
    std::string text() const {
        return count_ > 5 ? fmt::format("nodes {}, ... ({} in all)", text_, count_) : fmt::format("node {}", text_);
    }

  private:
    int count_ = 0;
    std::string text_;
};

/// Translations that IBC may free at an impact, as bits 4 x + 2 y + z of every interface with the node on its secondary
/// side.
std::vector<int> releasable(const Model& model) {
    std::vector<int> bits(static_cast<size_t>(model.nodes.size()), 0);
    for (const Interface& interface : model.interfaces) {
        if (interface.ibc == 0) continue;
        for (const int node : interface.secondary.node)
            bits[static_cast<size_t>(node)] |= interface.ibc;
    }
    return bits;
}

Mat3 axes_of(const Model& model, int skew) {
    return skew < 0 ? Mat3(Mat3::Identity()) : model.skews[static_cast<size_t>(skew)].axes;
}

/// The axis of one triad that is a given axis of another.
struct SignedAxis {
    int axis = -1;         ///< -1: none is
    bool opposed = false;  ///< it points the other way
};

SignedAxis axis_like(const Model& model, int skew, int axis, int other) {
    if (skew == other) return {axis, false};
    constexpr double rounding = 1e-12;  // of two unit vectors that a deck gives with all their digits
    const Vec3 cosines = axes_of(model, other).transpose() * axes_of(model, skew).col(axis);
    for (int i = 0; i < 3; ++i) {
        if (std::abs(std::abs(cosines[i]) - 1.0) <= rounding) return {i, cosines[i] < 0};
    }
    return {};
}

/// Fixes the translations (kind 0) or rotations (kind 1) of a /BCS. False where its directions are none of the node's.
bool fix(const Model& model, const BoundaryCondition& bcs, size_t kind, NodeConditions& node) {
    bool all = true;
    for (size_t d = 3 * kind; d < 3 * kind + 3; ++d)
        all = all && bcs.fixed[d];
    bool fits = true;
    for (int d = 0; d < 3; ++d) {
        if (!bcs.fixed[3 * kind + static_cast<size_t>(d)]) continue;
        // All three are the same in any axes.
        const int axis = all ? d : axis_like(model, bcs.skew, d, node.skew[kind]).axis;
        if (axis < 0) {
            fits = false;
        } else {
            node.fixed[3 * kind + static_cast<size_t>(axis)] = true;
        }
    }
    return fits;
}

/// The axes in which the conditions of each node hold: those of the first skew that one of them names.
void choose_axes(const Model& model, std::vector<NodeConditions>& conditions) {
    const auto choose = [&](int group, size_t kind, int skew) {
        if (skew < 0) return;
        for (const int node : model.groups[static_cast<size_t>(group)].nodes) {
            int& own = conditions[static_cast<size_t>(node)].skew[kind];
            if (own < 0) own = skew;
        }
    };
    for (const BoundaryCondition& bcs : model.boundary_conditions) {
        for (const size_t kind : {size_t{0}, size_t{1}}) {
            const auto first = bcs.fixed.begin() + static_cast<std::ptrdiff_t>(3 * kind);
            if (std::find(first, first + 3, true) != first + 3) choose(bcs.group, kind, bcs.skew);
        }
    }
    for (const ImposedMotion& motion : model.imposed_motions)
        choose(motion.group, motion.direction < 3 ? 0 : 1, motion.skew);
}

/// One problem for each card whose directions do not go with those of other cards.
void report_conflicts(const Model& model, const std::vector<ConditionConflict>& conflicts, Problems& problems) {
    std::vector<std::pair<std::string, NodeList>> cards;
    for (const ConditionConflict& conflict : conflicts) {
        auto found =
            std::find_if(cards.begin(), cards.end(), [&](const auto& entry) { return entry.first == conflict.card; });
        if (found == cards.end()) found = cards.insert(found, {conflict.card, NodeList()});
        found->second.add(model.nodes.id[static_cast<size_t>(conflict.node)]);
    }
    for (const auto& [card, nodes] : cards) {
        Problem problem;
        problem.place.file = model.deck_path;
        problem.card = card;
        problem.field = "skew_ID";
        problem.value = nodes.text();
        problem.rule =
            "the conditions of a node hold in the axes of the skew that one of them names; this one has a direction "
            "that is none of these axes";
        problem.remedy = "Give all conditions of these nodes in one skew";
        problems.add(problem);
    }
}

bool all_translations_driven(const NodeConditions& node, int released) {
    for (int d = 0; d < 3; ++d) {
        const bool freed = (released & (4 >> d)) != 0 && node.imposed[static_cast<size_t>(d)] < 0;
        if (!node.driven(d) || freed) return false;
    }
    return true;
}

}  // namespace

std::vector<NodeConditions> node_conditions(const Model& model, std::vector<ConditionConflict>* conflicts) {
    std::vector<NodeConditions> conditions(static_cast<size_t>(model.nodes.size()));
    choose_axes(model, conditions);
    const auto conflict = [&](int node, const std::string& card) {
        if (conflicts != nullptr) conflicts->push_back({node, card});
    };
    for (const BoundaryCondition& bcs : model.boundary_conditions) {
        for (const int node : model.groups[static_cast<size_t>(bcs.group)].nodes) {
            NodeConditions& own = conditions[static_cast<size_t>(node)];
            for (const size_t kind : {size_t{0}, size_t{1}}) {
                if (!fix(model, bcs, kind, own)) conflict(node, fmt::format("/BCS/{}", bcs.id));
            }
        }
    }
    for (size_t i = 0; i < model.imposed_motions.size(); ++i) {
        const ImposedMotion& motion = model.imposed_motions[i];
        const size_t kind = motion.direction < 3 ? 0 : 1;
        for (const int node : model.groups[static_cast<size_t>(motion.group)].nodes) {
            NodeConditions& own = conditions[static_cast<size_t>(node)];
            const SignedAxis same = axis_like(model, motion.skew, motion.direction % 3, own.skew[kind]);
            if (same.axis < 0 || same.opposed) {
                conflict(node, fmt::format("/{}/{}", keyword_of(motion.kind), motion.id));
            } else {
                own.imposed[3 * kind + static_cast<size_t>(same.axis)] = static_cast<int>(i);
            }
        }
    }
    return conditions;
}

std::vector<int> bodies_of_nodes(const Model& model) {
    std::vector<int> body(static_cast<size_t>(model.nodes.size()), -1);
    for (size_t b = 0; b < model.rigid_bodies.size(); ++b) {
        for (const int node : model.rigid_bodies[b].nodes)
            body[static_cast<size_t>(node)] = static_cast<int>(b);
        body[static_cast<size_t>(model.rigid_bodies[b].main_node)] = static_cast<int>(b);
    }
    return body;
}

void check_runnable(const HostScene& scene, Problems& problems, bool needs_end) {
    const Model& model = *scene.host;
    std::vector<ConditionConflict> conflicts;
    const auto conditions = node_conditions(model, &conflicts);
    const auto body = bodies_of_nodes(model);
    const auto released = releasable(model);

    std::vector<bool> deformable(static_cast<size_t>(model.nodes.size()), false);
    std::vector<bool> used(static_cast<size_t>(model.nodes.size()), false);
    for (const Shell& shell : model.shells) {
        const Part& part = model.parts[static_cast<size_t>(shell.part)];
        const bool is_void = model.materials[static_cast<size_t>(part.material)].law == MaterialLaw::none;
        for (const int node : shell.node) {
            used[static_cast<size_t>(node)] = true;
            if (!is_void) deformable[static_cast<size_t>(node)] = true;
        }
    }
    NodeList free_deformable;
    NodeList massless;
    for (int n = 0; n < model.nodes.size(); ++n) {
        const auto i = static_cast<size_t>(n);
        if (body[i] >= 0 || !used[i] || all_translations_driven(conditions[i], released[i])) continue;
        if (deformable[i]) free_deformable.add(model.nodes.id[i]);
        if (!(model.nodal_mass[i] > 0)) massless.add(model.nodes.id[i]);
    }
    Problem problem;
    problem.place.file = model.deck_path;
    if (free_deformable.count() > 0) {
        problem.card = "/BCS, /IMPVEL, /IMPDISP";
        problem.value = free_deformable.text();
        problem.rule =
            "a node of a deformable shell must be driven in X, Y and Z: this version computes no element forces";
        problem.remedy = "fix or drive all three translations (and leave IBC 000), or give the part a /MAT/VOID";
        problems.add(problem);
    }
    if (massless.count() > 0) {
        problem.card = "/MAT, /ADMAS";
        problem.value = massless.text();
        problem.rule = "a free node needs a mass [mass unit of the deck] > 0";
        problem.remedy = "give its material a density or add /ADMAS";
        problems.add(problem);
    }
    report_conflicts(model, conflicts, problems);
    for (const ConcentratedLoad& load : model.loads) {
        if (load.direction < 3) continue;
        NodeList loose;
        for (const int node : model.groups[static_cast<size_t>(load.group)].nodes) {
            if (body[static_cast<size_t>(node)] < 0) loose.add(model.nodes.id[static_cast<size_t>(node)]);
        }
        if (loose.count() == 0) continue;
        problem.card = fmt::format("/CLOAD/{}", load.id);
        problem.field = "Dir";
        problem.value = loose.text();
        problem.rule = "a moment acts on the nodes of a rigid body only: this version does not turn single nodes";
        problem.remedy = "load the main node of a /RBODY, or give a force (X, Y, Z)";
        problems.add(problem);
        problem.field.clear();
    }
    for (const RigidBody& tool : model.rigid_bodies) {
        const NodeConditions& main = conditions[static_cast<size_t>(tool.main_node)];
        const bool moves = !(main.driven(0) && main.driven(1) && main.driven(2));
        const bool turns = !(main.driven(3) && main.driven(4) && main.driven(5));
        problem.card = fmt::format("/RBODY/{}", tool.id);
        problem.remedy = "give the mass and inertia of the tool on the card, or drive its main node";
        if (moves && !(tool.mass > 0)) {
            problem.field = "Mass";
            problem.value = fmt::format("{} {}", tool.mass, model.units.name(dim::mass));
            problem.rule = "a tool that is free to move needs a mass > 0";
            problems.add(problem);
        }
        if (turns && !(tool.inertia.determinant() > 0)) {
            problem.field = "Jxx, Jyy, Jzz";
            problem.value = fmt::format("{}, {}, {} {}", tool.inertia(0, 0), tool.inertia(1, 1), tool.inertia(2, 2),
                                        model.units.name(dim::inertia));
            problem.rule = "a tool that is free to turn needs a positive definite inertia";
            problems.add(problem);
        }
    }
    check_time_span(model, problems);
    check_finite(model, problems);
    problem = {};
    problem.place.file = model.deck_path;
    if (needs_end && !(model.engine.end_time > 0)) {
        problem.card = "/RUN";
        problem.field = "T_end";
        problem.value = fmt::format("{} {}", model.engine.end_time, model.units.name(dim::time));
        problem.rule = "a run needs an end time > 0 from the engine deck";
        problem.remedy = "put NAME_0001.rad with /RUN/NAME/1 and its end time beside NAME_0000.rad";
        problems.add(problem);
    }
}

}  // namespace type21
