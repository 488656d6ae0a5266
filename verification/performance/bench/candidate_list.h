/// @file A contact step as OpenRadioss makes it, written from a description of what its engine computes: a list of
/// candidate pairs that is sorted anew when something has moved far enough, and in every cycle a box test, the
/// two-stage projection and the choice of the most central one for every pair of the list, then forces. Double
/// throughout; decisions are those of rounding. Only what the scenes of the bench need: Igap 0, Coulomb, one tool.
///
/// It is kinder than the original where that is simpler: no memory for vector groups, plain sums for the tool instead
/// of six-part ones, the tool's boxes looked at one by one only while sorting.
#pragma once

#include <array>
#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/contract/interface.h"
#include "reference/contract/motion.h"
#include "verification/performance/bench/closest_point.h"

namespace type21::bench {

/// Sizes fixed at the start, from the card and the blank.
struct SortSizes {
    double gap = 0, depth = 0;  ///< [length]
    double margin = 0;          ///< Bumult times the largest of mean edge and 1.251 DEPTH [length]
    double reach = 0;           ///< margin + largest of gap and DEPTH [length]
    double smallest_box = 0;    ///< boxes of this size are not halved any more [length]
};
SortSizes sort_sizes(double gap, double depth, double mean_edge, double bumult = 0.2);

struct CandidatePair {
    int node, segment;
};

/// Halves a box that holds all nodes again and again, segments with it, then tests boxes and distances.
/// @param y  nodes in the tool frame
std::vector<CandidatePair> sorted_pairs(const SurfaceMesh& tool, const std::vector<Vec3>& y, const SortSizes& sizes);

class CandidateList {
  public:
    /// @param tool, normal  in the tool frame   @param card  of the interface: stiffness, mass, VISs, Fric
    CandidateList(SurfaceMesh tool, std::vector<Vec3> normal, const Interface& card, double mean_edge);

    /// One cycle: search, projection, forces.
    void step(const Motion& motion);
    /// The same without forces.
    void search(const Motion& motion);
    /// What search() does when something has moved too far; separate so that it can be timed.
    void sort();

    struct Retained {
        int segment = -1;
        int triangle = 0;  ///< k
        int side = 0;
        double b = -1, c = -1;
    };
    const std::vector<Retained>& retained() const { return retained_; }
    const std::vector<Vec3>& force() const { return force_; }
    const Vec3& tool_force() const { return tool_force_; }
    size_t pairs() const { return pairs_.size(); }
    int sorts() const { return sorts_; }
    const SortSizes& sizes() const { return sizes_; }

  private:
    struct History {
        Vec3 friction = Vec3::Zero();
        double offset = 0;
        int cycles = 0;
    };
    void to_tool_frame(const Motion& motion);
    bool must_sort(const Motion& motion) const;
    bool in_box(const Vec3& p, int segment) const;
    void project(const CandidatePair& pair);
    void forces(const Motion& motion);
    void force_of(size_t i, const Motion& motion);

    SurfaceMesh tool_;
    std::vector<Vec3> normal_;
    const Interface& card_;
    SortSizes sizes_;
    std::vector<double> stiffness_;

    std::vector<Vec3> y_;         ///< nodes in the tool frame
    std::vector<Vec3> sorted_x_;  ///< nodes when the list was made
    Vec3 sorted_tool_ = Vec3::Zero();
    Vec3 sorted_arm_ = Vec3::Zero(), arm_ = Vec3::Zero();  ///< farthest node of the tool, turned
    std::vector<CandidatePair> pairs_;
    std::vector<Retained> retained_;
    std::vector<double> kappa_;
    std::vector<History> history_;
    std::vector<Vec3> force_;
    std::vector<double> step_stiffness_;
    Vec3 tool_force_ = Vec3::Zero(), tool_moment_ = Vec3::Zero();
    double tool_stiffness_ = 0, tool_rotation_ = 0;
    double elastic_energy_ = 0, damping_work_ = 0, friction_work_ = 0;
    int sorts_ = 0;
};

}  // namespace type21::bench
