/// @file A run kept in memory, to be compared with the run of a changed scene.
///
/// The tests of this folder say under which changes the results stay the same, and how nearly. What changes by design:
///  - Equal kappa: of two sub-triangles with the same kappa, the one of the lowest segment, then the lowest k, is
///    retained. Renumbering or mirroring the segments of the tool makes it another one. On a surface that both
///    continue, the force is the same to rounding. Where they meet in a fold and the node is exactly over it, the force
///    may differ.
///  - Nodal normals are sums of unit normals in the order of the segments. Another order changes them by some ulp. The
///    same holds for the centre of a quad whose corners are listed in another order.
///  - A quad whose list of corners begins with another corner has its sub-triangles k renumbered; they are the same.
///  - History: P0 is the penetration of the first cycle of an impact and loses 5 % in each cycle, not per time. So a
///  run
///    with half the step is another run, not a finer one of the same.
///  - The first cycle of an impact: where a node just reaches the gap in a cycle, the impact begins in this cycle or in
///    the next, depending on the last bits of its position. P0 then differs by the approach of one cycle. Any change of
///    rounding may cause it: units of length, a translation, a rotation. The law takes 16 ulp of the coordinate as no
///    impact; this covers the rounding of one cycle, not the sum over many.
///  - D29 uses the ids of the deck and changes when nodes are renumbered. It is off by default.
///  - There is no restart: a run that was stopped has to begin again.
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
    std::vector<double> temperature;  ///< empty without heat [K]
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
