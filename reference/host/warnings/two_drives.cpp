/// @file Two cards that drive one freedom of one node, and drives of nodes that a rigid body moves.
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"
#include "reference/model/motion_keyword.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

/// What drives a freedom: an imposed motion, or -1 - i for the boundary condition i.
using Drive = int;

struct Clash {
    int nodes = 0;
    int first_node = -1;
};

class Drives {
  public:
    explicit Drives(const SurpriseCheck& check) : check_(check), of_node_(at(check.model.nodes.size())) {
        const Model& model = check.model;
        for (size_t i = 0; i < model.boundary_conditions.size(); ++i)
            for (size_t d = 0; d < 6; ++d)
                if (model.boundary_conditions[i].fixed[d])
                    add(-1 - static_cast<int>(i), model.boundary_conditions[i].group, static_cast<int>(d));
        for (size_t i = 0; i < model.imposed_motions.size(); ++i)
            add(static_cast<int>(i), model.imposed_motions[i].group, model.imposed_motions[i].direction);
    }

    void report() const {
        for (const auto& [who, clash] : clashes_) {
            const auto& [first, second, direction] = who;
            check_.at_card(keyword(second), id(second), "Dir",
                           fmt::format("{} of node {}{}", direction_names[at(direction)],
                                       check_.model.nodes.id[at(clash.first_node)],
                                       clash.nodes > 1 ? fmt::format(" and {} more", clash.nodes - 1) : ""),
                           fmt::format("is driven by /{}/{} too: of two drives of one freedom the later imposed motion "
                                       "in the deck alone acts",
                                       keyword(first), id(first)),
                           "Remove one of the two, or take the nodes out of one group");
        }
    }

  private:
    void add(Drive drive, int group, int direction) {
        if (group < 0) return;
        for (const int node : check_.model.groups[at(group)].nodes) {
            auto& drives = of_node_[at(node)];
            for (const auto& [other, its_direction] : drives)
                if (its_direction == direction && clash(other, drive)) note(other, drive, direction, node);
            drives.emplace_back(drive, direction);
        }
    }

    void note(Drive first, Drive second, int direction, int node) {
        Clash& clash = clashes_[{first, second, direction}];
        if (clash.nodes++ == 0) clash.first_node = node;
    }

    /// Two boundary conditions say the same. Motions that take turns do not meet; sensors may see to that.
    bool clash(Drive first, Drive second) const {
        if (first < 0 && second < 0) return false;
        if (skew(first) != skew(second)) return false;  // check_runnable judges directions of several axes
        if (first < 0 || second < 0) return true;
        const ImposedMotion& a = check_.model.imposed_motions[at(first)];
        const ImposedMotion& b = check_.model.imposed_motions[at(second)];
        if (a.sensor != b.sensor) return false;
        return a.start < b.stop && b.start < a.stop;
    }

    int skew(Drive drive) const {
        return drive < 0 ? check_.model.boundary_conditions[at(-1 - drive)].skew
                         : check_.model.imposed_motions[at(drive)].skew;
    }

    std::string_view keyword(Drive drive) const {
        return drive < 0 ? "BCS" : keyword_of(check_.model.imposed_motions[at(drive)].kind);
    }

    Id id(Drive drive) const {
        return drive < 0 ? check_.model.boundary_conditions[at(-1 - drive)].id
                         : check_.model.imposed_motions[at(drive)].id;
    }

    const SurpriseCheck& check_;
    std::vector<std::vector<std::pair<Drive, int>>> of_node_;
    std::map<std::tuple<Drive, Drive, int>, Clash> clashes_;
};

/// Nodes that follow a rigid body cannot be moved by another card.
void warn_of_driven_followers(const SurpriseCheck& check) {
    const Model& model = check.model;
    std::vector<int> body(at(model.nodes.size()), -1);
    for (size_t b = 0; b < model.rigid_bodies.size(); ++b)
        for (const int node : model.rigid_bodies[b].nodes)
            body[at(node)] = static_cast<int>(b);
    for (const ImposedMotion& motion : model.imposed_motions) {
        if (motion.group < 0) continue;
        int count = 0;
        int first = -1;
        for (const int node : model.groups[at(motion.group)].nodes)
            if (body[at(node)] >= 0 && count++ == 0) first = node;
        if (count == 0) continue;
        const RigidBody& tool = model.rigid_bodies[at(body[at(first)])];
        check.at_card(
            keyword_of(motion.kind), motion.id, "grnd_ID",
            fmt::format("{} node{}, the first {}", count, count == 1 ? "" : "s", model.nodes.id[at(first)]),
            fmt::format("belong to the rigid body {} and follow its main node: this drive does not move them", tool.id),
            fmt::format("Drive the main node {} of the body", model.nodes.id[at(tool.main_node)]));
    }
}

}  // namespace

void warn_of_two_drives(const SurpriseCheck& check) {
    Drives(check).report();
    warn_of_driven_followers(check);
}

}  // namespace type21
