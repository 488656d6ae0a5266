/// @file A tool and a few nodes of unit mass in code: the scenes of the long runs. Mg, mm, s.
#pragma once

#include <vector>

#include "reference/host/march.h"
#include "reference/model/host_scene.h"
#include "verification/stability/tool_shapes.h"

namespace type21::stability {

inline constexpr double stiffness = 1000.0;  ///< k of every node, Istf 1 [N/mm]
inline constexpr double node_mass = 1.0;     ///< m of every node [Mg]
inline constexpr double gap = 1.0;           ///< g, Igap 0 [mm]
inline constexpr double depth = 2.0;         ///< DEPTH [mm]

/// The tool's main node is in the origin and held. VISs 0 and Fric 0 unless the caller sets them on card().
class BenchScene {
  public:
    BenchScene(const Tool& tool, const std::vector<Vec3>& blank);

    Interface& card() { return model_.interfaces[0]; }
    int blank_node(int i) const { return model_.interfaces[0].secondary.node[static_cast<size_t>(i)]; }
    int tool_node() const { return 0; }

    /// A constant time step, and an end that gives this many cycles.
    void steps(double step, long cycles);
    void hold(int node);
    /// The tool turns at this rate [rad/s] about its main node, direction 3 to 5.
    void turn_tool(int direction, double rate);
    /// A load in direction 0 to 2 [N]: from 0 to its value in `ramp` [s], then constant; 0: at once.
    void load(int node, int direction, double force, double ramp);

    HostScene scene() const;

  private:
    int add_node(Id id, const Vec3& x);
    int group_of(int node);
    int function(std::vector<double> x, std::vector<double> y);

    Model model_;
};

/// One node that is led through the seam without a host: position and velocity of each cycle are given.
class PrescribedNode {
  public:
    PrescribedNode(const HostScene& scene, const MakeContact& make_contact);
    /// One cycle of length `step` [s] that ends at x [mm], reached with velocity v [mm/s].
    NodeContact to(const Vec3& x, const Vec3& v, double step);

  private:
    HostScene scene_;
    std::unique_ptr<ContactMethod> contact_;
    std::vector<Vec3> position_, velocity_;
    double time_ = 0;
    bool begun_ = false;
};

}  // namespace type21::stability
