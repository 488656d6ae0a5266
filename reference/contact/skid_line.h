/// @file Skid line: where the sheet has slid under how large a tangential force (manual page: Pskid;
/// Formulation 9, step 14).
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace type21::reference {

/// |F_t| sqrt(3) / (Pskid A), capped at 1, of a node that slides; 0 of one that sticks.
/// @param slides  the friction force is at its limit
/// @param force   |F_t| [force]
/// @param pskid   Pskid, > 0 [pressure]
/// @param area    A [length^2]
/// @return r [-], 0 to 1; 0 where the area is 0.  Formulation 9, step 14.
/// @manual field Pskid
inline double skid_ratio(bool slides, double force, double pskid, double area) {
    return slides && area > 0 ? std::min(1.0, force * std::sqrt(3.0) / (pskid * area)) : 0.0;
}

/// The largest ratio of each node since the start. Present only when the card gives Pskid. i: rank in
/// SecondarySide::node, not checked.
class SkidLine {
  public:
    explicit SkidLine(int nodes) : largest_(static_cast<size_t>(nodes), 0.0) {}
    /// @return the envelope of node i with this cycle in it [-]
    double record(int i, double ratio) {
        double& largest = largest_[static_cast<size_t>(i)];
        largest = std::max(largest, ratio);
        return largest;
    }
    /// The envelope of node i so far [-].
    double largest(int i) const { return largest_[static_cast<size_t>(i)]; }
    /// What a checkpoint holds; @see StateWriter
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(largest_);
    }

    static constexpr size_t bytes_per_node() { return sizeof(double); }

  private:
    std::vector<double> largest_;
};

}  // namespace type21::reference
