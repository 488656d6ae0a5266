/// @file Differences of one quantity in units of the last place: the largest, where, and how they are distributed.
#pragma once

#include <array>
#include <string>

#include "reference/contract/mesh.h"

namespace type21 {

/// One unit in the last place of a magnitude m is m 2^-52: between one and two of the spacings of doubles near m.
inline constexpr double ulp_of_one = 0x1p-52;

/// Where something happened in a run.
struct LockstepPlace {
    long cycle = -1;
    double time = 0;  ///< [time]
    Id interface = 0;
    Id node = 0;  ///< 0: of the interface as a whole
};

/// Counts of differences, in bins: 1/16 wide up to 64, then doubling. The bins make percentiles cheap for any length of
/// run.
class UlpTally {
  public:
    explicit UlpTally(std::string name) : name_(std::move(name)) {}

    /// @param difference  |ours - reference| [unit of the quantity]
    /// @param scale       magnitude that one unit in the last place is taken of; with 0 any difference is infinite
    void add(double difference, double scale, const LockstepPlace& place);
    UlpTally& operator+=(const UlpTally& other);

    const std::string& name() const { return name_; }
    long compared() const { return compared_; }
    long equal() const { return equal_; }        ///< the very same bits (or 0 and -0)
    double largest() const { return largest_; }  ///< [ulps]
    const LockstepPlace& where() const { return where_; }
    /// Upper end of the bin below which the share lies, never more than largest().
    /// @param share  0.99: the 99th percentile
    double percentile(double share) const;

  private:
    static constexpr int fine = 1024;  ///< bins of 1/16
    static constexpr int coarse = 64;  ///< bins that double
    static double upper_end(int bin);

    std::string name_;
    long compared_ = 0, equal_ = 0;
    double largest_ = 0;
    LockstepPlace where_;
    std::array<long, fine + coarse> bins_{};
};

}  // namespace type21
