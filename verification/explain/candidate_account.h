/// @file Why each candidate sub-triangle accepts or rejects a node, with the numbers that decided: the projection and
/// its tests, Formulation 3, step 1 to step 5.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "reference/cycle/inspect.h"

namespace type21 {

/// The numbers of one projection, as far as it went.
struct ProjectionRecord {
    int step = 0;                                          ///< the last step of the projection that was reached, 1 to 3
    double height = 0;                                     ///< H [length^3]
    std::optional<std::array<double, 3>> corner_slopes;    ///< <n_A,N>, <n_B,N>, <n_C,N> [length^2]; none where H = 0
    std::optional<double> turn;                            ///< <M,N> [length^4]
    std::optional<reference::Barycentric<double>> lifted;  ///< b', c' [-]
    std::optional<double> slope;                           ///< <n,N> [length^2]
    std::optional<reference::Barycentric<double>> weights;  ///< b, c [-]

    /// What project() calls.
    void operator()(reference::ProjectionStep at, double value);
    void operator()(reference::ProjectionStep at, double first, double second);
    void operator()(reference::ProjectionStep at, double first, double second, double third);
};

/// One sub-triangle of a candidate segment.
struct SubTriangleAccount {
    int triangle = 0;        ///< k, 1..4
    Kind kind = Kind::none;  ///< none: rejected
    int step = 0;            ///< the step that rejected it (5: too far), 0 if none did
    std::string reason;      ///< "b' = -0.51 < -0.01"; of a taken one "d = 0.2 < g = 0.5"
    ProjectionRecord numbers;
    int side = 0;         ///< 0 where step 4 was not reached
    double distance = 0;  ///< d, to the clipped point [length]
    double kappa = 0;     ///< of a taken one [-]
};

struct SegmentAccount {
    int segment = -1;  ///< rank in the main surface
    std::vector<SubTriangleAccount> triangles;
};

struct CandidateAccount {
    std::vector<SegmentAccount> segments;  ///< ascending
    reference::Impact<double> retained;    ///< by the rule of Formulation 4, step 3
    std::string why;                       ///< "smallest kappa: 0.31 against 0.52 of segment 46, k = 2"
    int taken = 0;                         ///< sub-triangles that would take the node
    int rejected = 0;
};

/// All candidates of secondary node i at tool-frame position y.
CandidateAccount account_candidates(const reference::Inspect& inspect, int i, const Vec3& y);

}  // namespace type21
