/// @file Normal force and friction of many nodes at once.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "optimized/kernel/columns.h"
#include "optimized/kernel/node_data.h"
#include "optimized/simd/lanes.h"

namespace type21::optimized {

/// Nodes of a part of a batch. A row holds one number, a column one node. Global axes.
struct ForceRows {
    static constexpr int capacity = Search::Batch::part;
    using Row = double[capacity];

    int rank = 0;                 ///< of the node in the first column
    int at = 0;                   ///< its index in the batch
    int count = 0;                ///< columns
    ChunkLists* lists = nullptr;  ///< of the chunk; friction laws only
    bool full_report = true;      ///< fill all rows; else in_contact, offset, friction, force and step_stiffness only
    // Input. Masks are all ones or all zeros.
    alignas(64) long long contact[capacity];  ///< retained, and contact
    alignas(64) long long first[capacity];    ///< this is the first cycle of an impact
    const double* gap;                        ///< g [length]
    const double* stiffness;                  ///< k [force/length]
    const double* increment;                  ///< k of the friction increment [force/length]
    const double* mass;                       ///< [mass]
    double* offset;                           ///< P0; of the new cycle afterwards [length]
    alignas(64) Row velocity[3];              ///< of the node; relative to the tool afterwards [velocity]
    alignas(64) Row friction[3];              ///< F_t; of the new cycle afterwards [force]
    alignas(64) Row growth;                   ///< max(g - g0, 0), Pmax only [length]
    alignas(64) Row pmax_force;               ///< P_A = A Pmax, Pmax only [force]

    // Result; not a number where there is no contact.
    alignas(64) long long in_contact[capacity];  ///< p_g > 0
    alignas(64) long long slides[capacity];      ///< friction only
    alignas(64) Row distance;                    ///< delta [length]
    alignas(64) Row normal[3];                   ///< nu [-]
    alignas(64) Row point[3];                    ///< X [length]
    alignas(64) Row p_g;                         ///< p_g [length]
    alignas(64) Row penetration;                 ///< p [length]
    alignas(64) Row acting;                      ///< k, 0 where it does not act [force/length]
    alignas(64) Row damping;                     ///< C [force time/length]
    alignas(64) Row elastic;                     ///< F [force]
    alignas(64) Row energy;                      ///< [energy]
    alignas(64) Row normal_force;                ///< F_n [force]
    alignas(64) Row sliding;                     ///< speed across nu, friction laws only [velocity]
    alignas(64) Row mu;                          ///< friction laws only [-]
    alignas(64) Row force[3];                    ///< on the node; 0 without contact [force]
    alignas(64) Row step_stiffness;              ///< k + C/dt1; 0 without contact [force/length]

    /// Prepares the input of the nodes from `start` on, which are in the batch from `first_in_batch` on. The arrays of
    /// the nodes are read, and the offset is written, in place. A part of a register goes through a copy.
    /// @return false where none of them is in contact; then nothing else is filled
    bool prepare(NodeData& nodes, int start, const Search::Batch& batch, int first_in_batch,
                 std::span<const Vec3> speeds, bool with_damping, bool with_friction);
    /// Stores the history of the nodes: of these forces, or of none.
    void store_history(NodeData& nodes, bool acts) const;
    /// Stores force and stiffness of the nodes, likewise. @param all_forces, all_stiffness  by rank of node
    void store_forces(bool acts, Vec3* all_forces, double* all_stiffness) const;

  private:
    Row copy[5];
};

/// Columns are computed by full registers.
inline int full_registers(int count) {
    return (count + 7) / 8 * 8;
}

/// Copies numbers of nodes to a row.
inline void fetch(const std::vector<double>& from, int first, int count, double* to) {
    std::copy_n(from.data() + first, count, to);
}

/// The arrays that a step reads for decisions, and those that it reads and writes for forces.
Prefetcher prefetched_by_search(const NodeData& nodes, const Motion& motion);
void add_forces(const NodeData& nodes, const Motion& motion, const Vec3* forces, const double* stiffness,
                Prefetcher& ahead);

/// Numbers of all nodes of a cycle.
struct ForceCycle {
    ForceCycle(const Laws& laws, const Cycle& cycle);

    const Laws* laws;
    double rotation[3][3];        ///< R
    double center[3];             ///< x_G [length]
    double speed[3], turning[3];  ///< V_t, Omega
    double viss;                  ///< [-]
    double step, per_step;        ///< dt1; 1/dt1, 0 where there is none
    double filtered_step;         ///< alpha dt of the friction increment [time]
    double mu;                    ///< Coulomb [-]
    bool limited;                 ///< ITlim 0: friction is bounded by A Pmax / sqrt(3)
    bool inacti6;
};

/// From Formulation 5, step 1 to Formulation 8, step 10 at t > 0, for nodes of a batch whose retained impacts are
/// known. Fills the block with the terms of the sums, zeros where in_contact is false.
using Forces = void (*)(const ForceCycle&, const Search::Batch&, ForceRows&, TermBlock&);
/// @param effects  of damping, friction, law and pmax
Forces forces_for(unsigned effects, SimdWidth machine = this_machine());

/// mu of some columns, from the rows in_contact, normal_force and sliding.
void coefficients_in_rows(const ForceCycle& cycle, const Search::Batch& batch, ForceRows& rows, int column, int count);

/// y = R^T (x - x_G) of the nodes of a batch, which has x in the rows of y. The operations and their order are part of
/// the position that decisions are exact for.
void to_tool_frame(Search::Batch& batch, int count, const ForceCycle& cycle, SimdWidth machine = this_machine());

}  // namespace type21::optimized
