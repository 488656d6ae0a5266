#include "reference/host/conditions.h"

#include <fmt/format.h>

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

bool all_translations_driven(const NodeConditions& node, int released) {
    for (int d = 0; d < 3; ++d) {
        const bool freed = (released & (4 >> d)) != 0 && node.imposed[static_cast<size_t>(d)] < 0;
        if (!node.driven(d) || freed) return false;
    }
    return true;
}

}  // namespace

std::vector<NodeConditions> node_conditions(const Model& model) {
    std::vector<NodeConditions> conditions(static_cast<size_t>(model.nodes.size()));
    for (const BoundaryCondition& bcs : model.boundary_conditions) {
        for (const int node : model.groups[static_cast<size_t>(bcs.group)].nodes) {
            for (size_t d = 0; d < 6; ++d) {
                if (bcs.fixed[d]) conditions[static_cast<size_t>(node)].fixed[d] = true;
            }
        }
    }
    for (size_t i = 0; i < model.imposed_motions.size(); ++i) {
        const ImposedMotion& motion = model.imposed_motions[i];
        for (const int node : model.groups[static_cast<size_t>(motion.group)].nodes) {
            conditions[static_cast<size_t>(node)].imposed[static_cast<size_t>(motion.direction)] = static_cast<int>(i);
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
    const auto conditions = node_conditions(model);
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
