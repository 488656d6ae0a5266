/// @file Normal force and friction of many nodes at once.
#pragma once

#include <cstring>
#include <vector>

#include "optimized/kernel/node_data.h"
#include "optimized/lanes.h"

namespace type21::optimized {

/// Up to `room` nodes: a row a number, a column a node. Global axes.
struct ForceRows {
    static constexpr int room = LandingRows::room;
    using Row = double[room];

    int rank = 0;  ///< of the node in the first column
    // Asked. Masks are all ones or all zeros.
    alignas(64) long long contact[room];  ///< retained, and contact
    alignas(64) long long first[room];    ///< this is the first cycle of an impact
    alignas(64) Row gap;                  ///< g [length]
    alignas(64) Row stiffness;            ///< k [force/length]
    alignas(64) Row increment;            ///< k of the friction increment [force/length]
    alignas(64) Row mass;                 ///< [mass]
    alignas(64) Row offset;               ///< P0; of the new cycle when found [length]
    alignas(64) Row velocity[3];          ///< of the node; relative to the tool when found [velocity]
    alignas(64) Row friction[3];          ///< F_t; of the new cycle when found [force]
    alignas(64) Row growth;               ///< max(g - g0, 0), Pmax only [length]
    alignas(64) Row most;                 ///< A Pmax, Pmax only [force]

    // Found; not a number where there is no contact.
    alignas(64) long long closed[room];  ///< p_g > 0
    alignas(64) long long slides[room];  ///< friction only
    alignas(64) Row distance;            ///< delta [length]
    alignas(64) Row normal[3];           ///< nu [-]
    alignas(64) Row point[3];            ///< X [length]
    alignas(64) Row deep;                ///< p_g [length]
    alignas(64) Row penetration;         ///< p [length]
    alignas(64) Row acting;              ///< k, 0 where it does not act [force/length]
    alignas(64) Row damping;             ///< C [force time/length]
    alignas(64) Row elastic;             ///< F [force]
    alignas(64) Row energy;              ///< [energy]
    alignas(64) Row normal_force;        ///< F_n [force]
    alignas(64) Row sliding;             ///< speed across nu, friction laws only [velocity]
    alignas(64) Row mu;                  ///< friction laws only [-]
    alignas(64) Row force[3];            ///< on the node; 0 where it is not closed [force]
    alignas(64) Row step_stiffness;      ///< k + C/dt1; 0 where it is not closed [force/length]
};

/// Columns are computed by whole registers.
inline int whole_registers(int count) {
    return (count + 7) / 8 * 8;
}

/// Some numbers of nodes into a row.
inline void fetch(const std::vector<double>& from, int first, int count, double* to) {
    std::memcpy(to, from.data() + first, static_cast<size_t>(count) * sizeof(double));
}
/// A vector into a column of three rows.
template <class Vector, size_t room>
void fetch(const Vector& from, double (*to)[room], int j) {
    for (int a = 0; a < 3; ++a)
        to[a][j] = from[a];
}

/// What holds for all nodes of a cycle.
struct ForceCycle {
    ForceCycle(const Laws& laws, const Cycle& cycle);

    const Laws* laws;
    double rotation[3][3];        ///< R
    double center[3];             ///< x_G [length]
    double speed[3], turning[3];  ///< V_t, Omega
    double viss;                  ///< [-]
    double step, per_step;        ///< dt1; 1/dt1, 0 where there is none
    double rubbing;               ///< alpha dt of the friction increment [time]
    double mu;                    ///< Coulomb [-]
    bool limited;                 ///< ITlim 0: friction is bounded by A Pmax / sqrt(3)
    bool inacti6;
};

/// Sections 5 to 8 of the formulation at t > 0 for the nodes of a batch from `first` on, which have their places.
/// Writes the terms of the sums from `column` of the block on, zeros where a node is not closed.
using Forces = void (*)(const ForceCycle&, const Search::Batch&, int first, ForceRows&, int count, TermBlock&,
                        int column);
/// @param effects  of damping, friction, law and pmax
Forces forces_for(unsigned effects, Machine machine = this_machine());

/// mu of some columns whose closed, normal_force and sliding stand in the rows. @param first  node of the batch in the
/// first column
void coefficients_in_rows(const ForceCycle& cycle, const Search::Batch& batch, int first, ForceRows& rows, int column,
                          int count);

/// y = R^T (x - x_G) of the nodes of a batch, which has x in its place; the operations and their order are part of the
/// position that decisions are exact for.
void to_tool_frame(Search::Batch& batch, int count, const ForceCycle& cycle, Machine machine = this_machine());

}  // namespace type21::optimized
