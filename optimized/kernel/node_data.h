/// @file What the kernel reads and writes: constants and history of the secondary nodes, one array each.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "optimized/kernel/friction_law.h"
#include "optimized/kernel/gap_law.h"
#include "optimized/kernel/heat_law.h"
#include "optimized/search/search.h"
#include "optimized/sums/step_sums.h"
#include "reference/contract/contact_step.h"
#include "reference/contract/motion.h"
#include "reference/contract/scene.h"

namespace type21::optimized {

/// Effects that a kernel can be compiled for. `law`: friction laws other than Coulomb's, and pairs of parts. `lists`:
/// what is reported of single nodes beside their forces (release, skid line, test of the normals). `rare`: everything
/// else, that is departures of the contact geometry, friction by temperature, deletion.
namespace effect {
constexpr unsigned damping = 1, friction = 2, pmax = 4, heat = 8, rare = 16, any = 32, law = 64, lists = 128;
}

/// Constants and history of the secondary nodes; index: rank in SecondarySide::node. Arrays of effects that the scene
/// does not have stay empty.
struct NodeData {
    std::vector<int> node;                   ///< index into Model::nodes
    std::vector<double> gap;                 ///< g [length]
    std::vector<double> search_gap;          ///< that decides contact; empty when it is g (all but D33) [length]
    std::vector<double> stiffness;           ///< k; 0 once Inacti 1 has switched the node off [force/length]
    std::vector<double> friction_stiffness;  ///< empty when it is k (all but D04) [force/length]
    std::vector<double> mass;                ///< [mass]

    std::vector<double> offset;  ///< P0 [length]
    std::vector<int> cycles;     ///< consecutive cycles retained in contact with p_g > 0
    std::vector<Memory> memory;  ///< of the search; the sorted search has none
    std::vector<V3> friction;    ///< F_t of the last cycle, global axes [force]
    std::vector<double> skid;    ///< largest ratio since the start [-]
    std::vector<char> released;  ///< IBC

    Memory* memory_from(int first) { return memory.empty() ? nullptr : memory.data() + first; }
    double deciding_gap(size_t i) const { return search_gap.empty() ? gap[i] : search_gap[i]; }
    double increment_stiffness(size_t i) const {
        return friction_stiffness.empty() || stiffness[i] == 0 ? stiffness[i] : friction_stiffness[i];
    }

    /// What the next cycle needs of the past. Every field is named here: one that is added later does not compile until
    /// it is decided whether it belongs to a checkpoint. The memory of the search changes no result, but what the
    /// search counts.
    template <class Archive>
    static void visit(Archive& archive, NodeData& data) {
        auto& [model_node, g, deciding, k, friction_k, m, p0, count, remembered, force, ratio, free] = data;
        archive(g, deciding, k, p0, count, remembered, ratio, free);
        for (V3& f : force)
            archive(f.x, f.y, f.z);
    }
};

/// What a chunk of nodes adds to a step, in the order of its nodes.
struct ChunkLists {
    FrictionBelowZero below_zero;
    FrictionOverflow overflow;
    std::vector<int> released;
    std::vector<InvertedNormal> inverted;
    std::vector<ToolHeat> tool_heat;
    void clear() {
        below_zero = {};
        overflow = {};
        released.clear();
        inverted.clear();
        tool_heat.clear();
    }
};

/// What stays the same over a run, beside the nodes.
struct Laws {
    Laws(const Scene& scene, int interface);

    bool as_built(Departure d) const { return model->as_built.has(d); }
    unsigned effects() const { return effects_; }
    bool has(unsigned one) const { return (effects_ & one) != 0; }
    /// mu of a node on a segment, of the law of the card or of the pair of parts. What is not finite is listed.
    /// @param factor  f_IDF [-]
    double friction_coefficient(int rank, int segment, double normal_force, double speed, double factor,
                                ChunkLists& lists) const;
    /// The sums that lanes_kernel fills; without friction the others are copies of these, or zero.
    std::span<const Term> terms() const { return terms_; }

    std::shared_ptr<const ContactModel> model;
    const Interface* card;
    Tool tool;
    std::unique_ptr<Search> search;
    ProjectionLimits rules;
    double proximity = 0;  ///< [length]

    FrictionLaw friction_law;
    FrictionTable friction_table;
    const Function* friction_of_temperature = nullptr;
    std::optional<HeatLaw> heat;
    std::optional<GapLaw> growth;
    std::optional<NodeShells> deletion;
    bool coulomb = true;  ///< mu is the Fric of the card for every node
    bool skid = false, release = false, normals_test = false;
    // Departures that the kernel has to know.
    bool d05 = false, d08 = false, d11 = false, d12 = false, d16 = false, d33 = false;

  private:
    unsigned effects_ = 0;
    std::vector<Term> terms_;
};

/// Numbers of one cycle.
struct Cycle {
    Cycle(const Laws& laws, const Motion& motion, int inacti);

    const Motion& motion;
    const ToolMotion& pose;
    bool time_zero;
    int inacti;
    double filter = 1;  ///< alpha [-]
};

struct ForceRows;

/// Where a kernel writes, by rank of node. Without `node`, only forces and stiffness are written.
struct Output {
    NodeContact* node = nullptr;
    NodeHeat* heat = nullptr;          ///< with heat
    double* skid = nullptr;            ///< with the skid line [-]
    Vec3* force = nullptr;             ///< [force]
    double* step_stiffness = nullptr;  ///< [force/length]
};

/// Working storage of one thread; only its allocated memory outlives a cycle.
struct Workspace {
    Workspace();
    Workspace(Workspace&&) noexcept;
    ~Workspace();

    TermBlock terms;
    StepSums sums;
    PathTally tally;
    std::unique_ptr<Search::Batch> batch;
    std::unique_ptr<ForceRows> forces;
    std::vector<NodeContact> nodes;  ///< of a chunk, for the lean step
};

/// One chunk of nodes, first <= i < last, of one cycle.
using Kernel = void (*)(const Laws&, const Cycle&, NodeData&, int first, int last, const Output&, ChunkLists&,
                        Workspace&);

/// The kernel that works node by node. With the effects of the scene only, where it is compiled; otherwise the general
/// one, which tests effects at run time.
Kernel kernel_for(unsigned effects);
/// The kernel for many nodes at once, for t > 0, no effects but damping, friction of any law, pmax and lists, and no
/// proximity.
void lanes_kernel(const Laws&, const Cycle&, NodeData&, int first, int last, const Output&, ChunkLists&, Workspace&);
inline bool in_lanes(unsigned effects) {
    return (effects & ~(effect::damping | effect::friction | effect::pmax | effect::law | effect::lists)) == 0;
}

}  // namespace type21::optimized
