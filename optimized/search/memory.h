/// @file What nodes remember of their last search.
#pragma once

#include <array>
#include <cmath>

#include "optimized/projection/vector3.h"
#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// A radius as a float that is no longer; 0 where there is none.
inline float shortened(double radius) {
    return radius > 0 ? std::nextafter(static_cast<float>(radius), 0.0F) : 0.0F;
}

/// What a node remembers to be quick. It never changes an answer: it only says where to look first, and everything that
/// is concluded from it is proven for the place where the node is now. @see Search on balls
struct Memory {
    V3 from;           ///< middle of the balls [length]
    float radius = 0;  ///< > 0: quiet, < 0: steady, 0: none [length]
    float held = 0;    ///< < 0: of the smaller ball in which it is held on that side: -1, > 0: 1; 0: none [length]
    int place = -1;    ///< sub-triangle retained last, as place_of gives it

    signed char side() const { return held > 0 ? 1 : -1; }
    /// Where to look first; without a ball.
    void look_at(int where) {
        place = where;
        radius = held = 0;
    }
    void keep_steady(int where, const V3& at, double ball) {
        place = where;
        from = at;
        radius = -shortened(ball);
        held = 0;
    }
    void keep_quiet(const V3& at, double ball) {
        from = at;
        radius = shortened(ball);
        held = 0;
    }
    /// How far it is from there to the rim of the steady ball [length]
    double left_at(const V3& y) const { return -double(radius) - norm(y - from) * (1 + 1e-9); }
    /// In the steady ball around another middle that lies in it.
    void keep_held(const V3& at, double ball, int on_side) {
        const double left = left_at(at);
        from = at;
        radius = -shortened(left);
        held = shortened(std::min(ball, left)) * static_cast<float>(on_side);
    }

    /// Does the ball hold y? Sums of three squares are right to 3 ulp; that of a float is exact.
    bool within(const V3& y) const { return within(y, double(radius)); }
    bool within_held(const V3& y) const { return within(y, double(held)); }
    bool quiet_at(const V3& y) const { return radius > 0 && within(y); }
    void forget() { radius = held = 0; }

  private:
    bool within(const V3& y, double ball) const {
        const V3 way = y - from;
        return dot(way, way) * (1 + 1e-14) < ball * ball;
    }
};

/// What memories say of nodes.
struct Recalled {
    static constexpr int room = 64;
    /// quiet: nothing takes it. core: its place is to be asked, and decides alone in its core. steady: its place is
    /// retained if it takes it. held: it is retained.
    enum What : int { nothing, quiet, core, steady, held };
    alignas(64) int what[room], place[room];

    /// @param y  rows of the components   @param small  steady balls that do not hold the node, smaller than this, say
    /// core [length]
    void find(const Memory* memory, const std::array<const double*, 3>& y, int count, float small,
              SimdWidth machine = this_machine());
    static What of(const Memory& memory, const V3& y, float small);
};

}  // namespace type21::optimized
