/// @file The ContactStep: the result of one cycle of a contact.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "decision.h"
#include "vector.h"

namespace type21 {

/// open: the stiffness of the node does not act. slip: its friction force is at the limit, or it has none.
/// Formulation 8, step 10.
enum class Status { open, stick, slip };

/// All of one node in one cycle, in global axes; zero where there is no impact.
struct NodeContact {
    Decision decision;
    Status status = Status::open;
    double gap = 0;                         ///< g [length]
    double distance = 0;                    ///< delta, signed, along the normal [length]
    double geometric_penetration = 0;       ///< p_g = max(0, g - delta) [length]
    double offset = 0;                      ///< P0 [length]
    double penetration = 0;                 ///< p = max(0, p_g - P0) [length]
    double stiffness = 0;                   ///< k; 0 where it does not act (Formulation 6, step 4) [force/length]
    double damping = 0;                     ///< C [force time/length]
    double elastic_force = 0;               ///< F, >= 0 [force]
    double elastic_energy = 0;              ///< integral of F dp [energy]
    double normal_force = 0;                ///< F_n = F - C v_n, positive pushes the node outward [force]
    Vec3 normal = Vec3::Zero();             ///< nu, outward [-]
    Vec3 point = Vec3::Zero();              ///< X, the contact point [length]
    Vec3 relative_velocity = Vec3::Zero();  ///< v of the node relative to the tool at X [velocity]
    Vec3 friction = Vec3::Zero();           ///< F_t, on the tool [force]
    Vec3 force = Vec3::Zero();              ///< on the node: F_n nu - F_t [force]
    double step_stiffness = 0;              ///< k + C/dt1, for the time step [force/length]
};

/// Heat of one node in one cycle; zero outside of every zone.  Formulation 9, step 6 to step 10.
struct NodeHeat {
    double heat = 0;                 ///< to the node from tool and friction [energy]
    double friction_heat = 0;        ///< Fheat q, a part of it [energy]
    double conductance = 0;          ///< A / (d/k_s + 1/K) of the conduction [power/temperature]
    double radiant_conductance = 0;  ///< A h_r of the radiation [power/temperature]
};

/// Heat that a tool node receives in one cycle.
struct ToolHeat {
    int node = -1;    ///< index into ContactModel::nodes
    double heat = 0;  ///< [energy]
};

/// What adaptive meshing is told of an element of the blank.  Formulation 9, step 15.
struct AdaptiveElement {
    double radius = 0;        ///< smallest tool radius at its nodes in contact [length]
    double cosine = 1;        ///< of the sharpest angle between tool normals there [-]
    double penetration = 0;   ///< largest p / g there [-]
    double longest_edge = 0;  ///< of the element now [length]
    bool divide = false;      ///< the element is to be divided
};

/// Sums over the nodes of one cycle; forces on the tool. Each is the exact sum rounded once, so no order matters.
/// Formulation 10, step 9; Formulation 11, step 8.
struct ContactSums {
    Vec3 normal = Vec3::Zero();      ///< of -F_n nu [force]
    Vec3 tangential = Vec3::Zero();  ///< of F_t [force]
    Vec3 abs_normal = Vec3::Zero();  ///< of |components of F_n nu| [force]
    double signed_normal = 0;        ///< of -F_n [force]
    Vec3 abs_total = Vec3::Zero();   ///< of |components of the force on the tool| [force]
    double norm_total = 0;           ///< of the norm of the force on the tool [force]
    double elastic_energy = 0;       ///< of this cycle [energy]
    double friction_work = 0;        ///< of dt1 <v, F_t> in this cycle [energy]
    double damping_work = 0;         ///< of C v_n^2 dt1 in this cycle [energy]
    double friction_heat = 0;        ///< of Fheat q in this cycle, QFRIC's share [energy]
    double heat_to_blank = 0;        ///< of all heat to nodes in this cycle [energy]
    double heat_to_tool = 0;         ///< of all heat to tool nodes in this cycle [energy]
};

/// What the contact gives to its tool, global axes.  Formulation 9, step 16; Formulation 11, step 5.
struct ToolLoad {
    Vec3 force = Vec3::Zero();           ///< of the contact: sum of -F_n nu + F_t [force]
    Vec3 moment = Vec3::Zero();          ///< of the contact about x_G: sum of (X - x_G) x (-F_n nu + F_t) [moment]
    Vec3 damping_force = Vec3::Zero();   ///< of the tool damping; its opposite acts on the tool of IDref [force]
    Vec3 damping_moment = Vec3::Zero();  ///< likewise [moment]
    double damping = 0;                  ///< C of the tool damping [force time/length]
    double rotational_damping = 0;       ///< likewise of the rotation [moment time]
    double step_stiffness = 0;           ///< sum of k + C/dt1, for the time step [force/length]
    double step_rotation = 0;            ///< sum of (k + C/dt1) |X - x_G|^2 [moment]
};

/// Invn: the first impact came from behind.  Formulation 7, step 9.
struct InvertedNormal {
    int node = -1;           ///< index into ContactModel::nodes
    int segment = -1;        ///< rank in the main surface
    double penetration = 0;  ///< p_g [length]
};

/// Nodes at which fct_IDF is negative, and with it Fric f_IDF.  Formulation 8, step 3.
struct FrictionBelowZero {
    int count = 0;           ///< nodes of this cycle
    int node = -1;           ///< the first, index into ContactModel::nodes
    double abscissa = 0;     ///< of fct_IDF there: AscaleF times the mean temperature of both sides [temperature]
    double coefficient = 0;  ///< Fric f_IDF there, before it is raised to 0 [-]
};

/// Nodes at which the friction law is not a finite number. Their forces mean nothing.  Formulation 8, step 7.
struct FrictionOverflow {
    int count = 0;        ///< nodes of this cycle
    int node = -1;        ///< the first, index into ContactModel::nodes
    int coefficient = 0;  ///< which of C1..C6 makes it so, from 0
    double value = 0;     ///< of that coefficient, in the units that the law asks for
    double speed = 0;     ///< s [velocity]
    double pressure = 0;  ///< F_n / A [pressure]
};

/// One cycle of one interface. Vectors are empty where their effect is absent, and while the interface is inactive.
struct ContactStep {
    bool active = false;             ///< Tstart, Tstop, sensor
    std::vector<NodeContact> nodes;  ///< like SecondarySide::node
    std::vector<NodeHeat> heat;      ///< likewise, with Ithe
    std::vector<double> skid;        ///< likewise, with Pskid: the largest skid ratio since the start [-]
    ContactSums sums;
    ToolLoad tool;
    std::vector<int> released;  ///< nodes (index into ContactModel::nodes) whose IBC translations are free from now on
    std::vector<InvertedNormal> inverted;  ///< with Invn, those of this cycle
    /// By segment node, a node may come more than once; empty unless the tool is heated.  Formulation 9, step 11.
    std::vector<ToolHeat> tool_heat;
    std::vector<AdaptiveElement> adaptive;  ///< like the segments of the secondary surface; empty without Iadm
    FrictionBelowZero friction_below_zero;
    FrictionOverflow friction_overflow;
    double smallest_gap_raw = 0;  ///< of g_s over the nodes, before Gapmin and Gapmax act [length]
    double largest_gap_raw = 0;   ///< the largest of g_s, likewise [length]
};

}  // namespace type21
