/// @file The number of a sub-triangle.
#pragma once

#include <compare>

namespace type21::optimized {

/// Sub-triangle k = 1..4 of a segment, k = 1 of a triangle, as one integer. It orders sub-triangles as a tie does: by
/// segment, then by k. Trivial, so that arrays of it cost what arrays of integers cost; a default-constructed one holds
/// nothing.
class SubTriangleId {
  public:
    SubTriangleId() = default;
    constexpr SubTriangleId(int segment, int triangle) : code_(4 * segment + triangle - 1) {}
    static constexpr SubTriangleId none() { return from_code(-1); }
    /// The reverse of code().
    static constexpr SubTriangleId from_code(int code) {
        SubTriangleId id(0, 1);
        id.code_ = code;
        return id;
    }

    constexpr bool exists() const { return code_ >= 0; }
    constexpr int segment() const { return code_ >> 2; }
    constexpr int triangle() const { return (code_ & 3) + 1; }
    /// 4 segment + k - 1; -1 for none.
    constexpr int code() const { return code_; }
    /// This id where the mask is all ones, none where it is zero; without a branch.
    constexpr SubTriangleId kept_by(int mask) const { return from_code((code_ & mask) | ~mask); }

    friend constexpr auto operator<=>(const SubTriangleId&, const SubTriangleId&) = default;

  private:
    int code_;
};

}  // namespace type21::optimized
