/// @file A run kept in memory, to be compared with the run of a changed scene.
///
/// What the method keeps, and to what it keeps it, is in the tests of this folder. What it breaks by design:
///  - Equal kappa: of two sub-triangles that take a node equally well the one of the lowest segment, then the lowest k
///  is
///    retained. Renumbering or mirroring the tool's segments makes it another one. On a surface that both continue the
///    force is the same to rounding; where they meet in a fold, with a node exactly over it, it may differ.
///  - Nodal normals are sums of unit normals in the order of the segments: another order rounds otherwise, by some ulp.
///    So does the centre of a quad whose corners are listed from another one on or the other way round.
///  - A quad whose corners begin elsewhere has its sub-triangles k renumbered; the pieces are the same.
///  - History: P0 is the penetration of the first cycle of an impact and loses 5 % in each cycle, not per time. A run
///  with
///    half the step is another run, not a finer one of the same.
///  - The first cycle of an impact: a node that comes to the very touch in a cycle begins its impact there or in the
///  next,
///    as the last bits of its position say; P0 differs by the approach of one cycle. Any change of rounding may do it:
///    units of length, a move, a turn. 16 ulp of the coordinate are no impact; that covers the rounding of a cycle, not
///    what many cycles have added up.
///  - D29 counts user ids of the model; it changes when nodes are renumbered. It is off unless asked for.
///  - A stop in the middle is no file: there is no restart. A run must be begun again.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "reference/host/march.h"
#include "reference/model/model.h"

namespace type21::test {

/// Everything of the nodes at some cycles (every 25th and the last); indexed like Model::nodes.
struct Snapshot {
    long cycle = 0;
    double time = 0;
    std::vector<Vec3> place, force;
    std::vector<Decision> decision;
};

struct Trace {
    std::vector<Snapshot> snapshots;
    std::vector<InterfaceTotals> totals;
    long cycles = 0;
    long in_contact = 0;       ///< node cycles
    double largest_force = 0;  ///< on a node
    double largest_impulse = 0;
};

/// Runs the reference on the model.
Trace run(const Model& model);

/// The resolved deck of a case; ends the test when it has errors.
Model case_model(const std::string& name);
/// The same with work units other than those of the deck, as /BEGIN writes them ("kg", "m", "s").
Model case_model_in(const std::string& name, const std::string& mass, const std::string& length,
                    const std::string& time);

}  // namespace type21::test
