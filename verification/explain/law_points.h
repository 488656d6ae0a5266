/// @file Where on its laws a run has been: friction over pressure and speed, pressure over penetration, heat over
/// distance; and the friction laws themselves, of both implementations.
#pragma once

#include <string>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

/// mu = |F_t| / |F_n| of a node that slips.
struct FrictionPoint {
    double pressure = 0;  ///< F_n / A [pressure]
    double speed = 0;     ///< |v - v_n nu| [velocity]
    double mu = 0;        ///< [-]
};

struct NormalPoint {
    double penetration = 0;  ///< p [length]
    double pressure = 0;     ///< F / A [pressure]
};

/// What Pmax did in a run: equation (5) lowers the force of a node where k p is more than F.
struct PressureLimit {
    size_t node_cycles = 0;  ///< nodes in contact, summed over the cycles
    size_t lowered = 0;      ///< of them with F < k p
    size_t plateau = 0;      ///< of them with F = A Pmax
    double first = 0;        ///< smallest penetration on the plateau [length]
    double last = 0;         ///< largest penetration on the plateau [length]
    double largest = 0;      ///< largest F / A [pressure]
};

struct HeatPoint {
    double distance = 0;     ///< delta [length]
    double conductance = 0;  ///< of the node's area, per area [power/(area temperature)]
};

/// The law at one speed.
struct FrictionCurve {
    double speed = 0;                  ///< [velocity]
    std::vector<double> mu;            ///< of the reference, at InterfaceLaws::pressures [-]
    std::vector<double> mu_optimized;  ///< [-]
};

struct InterfaceLaws {
    Id id = 0;
    std::string title;
    int ifric = 0;
    double pmax = 0;  ///< [pressure]; 0: no limit
    bool several_mu =
        false;  ///< parts, temperature or a limit of the tangential force change mu; curves are the card's
    std::vector<double> pressures;
    std::vector<FrictionCurve> curves;  ///< at up to three of the speeds that came about; none where nothing slips
    std::vector<FrictionPoint> friction;
    std::vector<NormalPoint> normal;  ///< with Pmax only
    PressureLimit limit;              ///< with Pmax only
    std::vector<HeatPoint> heat;      ///< with Ithe only
};

/// Runs the scene and keeps of each interface the points that differ by more than 3 % of the largest.
/// A run that stops leaves what came about until then.
std::vector<InterfaceLaws> law_points(const HostScene& scene, const MakeContact& make,
                                      const MarchOptions& options = {});

/// The largest difference of the two implementations' laws, relative to mu [-].
double largest_difference(const InterfaceLaws& laws);

}  // namespace type21
