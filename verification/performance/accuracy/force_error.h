/// @file Errors of forces: in units of the last place and relative, the largest and the 99th percentile.
#pragma once

#include <cstddef>
#include <vector>

namespace type21::accuracy {

/// |got - exact| in units of the last place of `exact`: spacings of the doubles there.
/// @param exact  > 0 and finite
double error_in_ulps(double got, double exact);

/// Collects the forces of one method on one scene.
class ForceErrors {
  public:
    /// @param got    force of the method; 0 where it finds no contact; may be infinite or NaN [force]
    /// @param exact  > 0 [force]
    /// @param scale  k times the largest length that enters, > 0 [force]
    void add(double got, double exact, double scale);
    /// Counts a force where the exact answer is no contact.
    void add_spurious() { ++spurious_; }

    size_t compared() const { return ulps_.size() + not_finite_; }
    size_t spurious() const { return spurious_; }
    size_t not_finite() const { return not_finite_; }  ///< overflowed or not a number; in no percentile
    /// The smallest of the errors that at least this share of the finite ones does not exceed; 0 for none.
    double ulps(double share) const { return at(ulps_, share); }
    double relative(double share) const { return at(relative_, share); }
    /// In units of the last place of what enters: what cancels in g - delta does not count.
    double scaled(double share) const { return at(scaled_, share); }

  private:
    static double at(const std::vector<double>& values, double share);

    std::vector<double> ulps_, relative_, scaled_;
    size_t spurious_ = 0, not_finite_ = 0;
};

}  // namespace type21::accuracy
