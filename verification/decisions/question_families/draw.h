/// @file Random numbers that are the same bits on every machine.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string_view>

#include "reference/contract/vector.h"

namespace type21 {

/// A stream of numbers. Two draws never stand in one expression whose order of evaluation C++ leaves open.
/// The generator is splitmix64 (Steele, Lea, Flood: Fast splittable pseudorandom number
/// generators, OOPSLA 2014); the mapping to doubles is ours, since that of the standard library is not fixed.
class Draw {
  public:
    /// One stream for each (name, seed, index).
    Draw(std::string_view name, std::uint64_t seed, std::uint64_t index);

    std::uint64_t bits();
    /// Uniform multiples of 2^-53 in [0, 1).
    double unit();
    double between(double low, double high) { return low + (high - low) * unit(); }
    /// 0 to count - 1.
    int below(int count);
    bool chance(double probability) { return unit() < probability; }
    double sign() { return chance(0.5) ? 1.0 : -1.0; }
    template <class Value>
    Value one_of(std::initializer_list<Value> values) {
        return values.begin()[below(static_cast<int>(values.size()))];
    }
    /// Uniform in the cube [-1, 1)^3.
    Vec3 in_cube();
    /// 2^k, k uniform from low to high.
    double power_of_two(int low, int high);

  private:
    std::uint64_t state_;
};

/// A double moved by whole ulps, up or down.
double moved(double value, int ulps);

/// Cosine and sine from + - x / only, so that they are the same bits with every mathematical library; within 1e-15.
struct Turn {
    double cosine;
    double sine;
};
Turn turn(double degrees);

/// Of unit length to rounding, at every scale; zero stays zero.
Vec3 unit_vector(const Vec3& v);

}  // namespace type21
