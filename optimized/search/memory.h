/// @file What nodes remember of their last search.
#pragma once

#include <array>
#include <cmath>

#include "optimized/projection/sub_triangle_id.h"
#include "optimized/projection/vector3.h"
#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// A radius as a float that is no larger; 0 where there is none.
inline float rounded_down(double radius) {
    return radius > 0 ? std::nextafter(static_cast<float>(radius), 0.0F) : 0.0F;
}

/// What a node remembers of its last search. It says where to look first and never changes an answer: everything that
/// is concluded from it is proven for the present position of the node. @see Search on the radii
struct Memory {
    V3 center;               ///< of both radii [length]
    float radius = 0;        ///< > 0: separated radius, < 0: minus the ranking safe radius, 0: none [length]
    float contact_safe = 0;  ///< contact safe radius, with the sign of the side; 0: none [length]
    SubTriangleId last = SubTriangleId::none();  ///< retained last

    signed char side() const { return contact_safe > 0 ? 1 : -1; }
    /// Where to look first, without a radius.
    void look_at(SubTriangleId id) {
        last = id;
        radius = contact_safe = 0;
    }
    void keep_ranking_safe(SubTriangleId id, const V3& at, double safe_radius) {
        last = id;
        center = at;
        radius = -rounded_down(safe_radius);
        contact_safe = 0;
    }
    void keep_separated(const V3& at, double separated_radius) {
        center = at;
        radius = rounded_down(separated_radius);
        contact_safe = 0;
    }
    /// What is left of the ranking safe radius at y [length]
    double left_at(const V3& y) const { return -double(radius) - norm(y - center) * (1 + 1e-9); }
    /// Moves the centre to `at`, which lies within the ranking safe radius; that radius shrinks accordingly.
    void keep_contact_safe(const V3& at, double safe_radius, int on_side) {
        const double left = left_at(at);
        center = at;
        radius = -rounded_down(left);
        contact_safe = rounded_down(std::min(safe_radius, left)) * static_cast<float>(on_side);
    }

    /// Is y within the radius? Sums of three squares are right to 3 ulp; the square of a float is exact.
    bool within(const V3& y) const { return within(y, double(radius)); }
    bool within_contact_safe(const V3& y) const { return within(y, double(contact_safe)); }
    bool separated_at(const V3& y) const { return radius > 0 && within(y); }
    void forget() { radius = contact_safe = 0; }

    template <class Archive>
    void visit_state(Archive& archive) {
        auto& [at, around, safe, id] = *this;
        int code = id.code();
        archive(at.x, at.y, at.z, around, safe, code);
        id = SubTriangleId::from_code(code);
    }

  private:
    bool within(const V3& y, double distance) const {
        const V3 way = y - center;
        return dot(way, way) * (1 + 1e-14) < distance * distance;
    }
};

/// What the memories of several nodes say.
struct Recalled {
    static constexpr int capacity = 64;
    /// separated: nothing takes the node. project: its last sub-triangle is projected on, and decides in its exclusive
    /// region. ranking_safe: its last sub-triangle is retained if it takes the node. contact_safe: it is retained.
    enum What : int { nothing, separated, project, ranking_safe, contact_safe };
    alignas(64) int what[capacity];
    alignas(64) SubTriangleId last[capacity];

    /// @param y  rows of the components   @param small  a node outside its ranking safe radius gets `project` only if
    /// that radius is smaller than this [length]
    void find(const Memory* memory, const std::array<const double*, 3>& y, int count, float small,
              SimdWidth machine = this_machine());
    static What of(const Memory& memory, const V3& y, float small);
};

}  // namespace type21::optimized
