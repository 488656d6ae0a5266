/// @file The projection in plain double, four nodes at a time, without a single bound: for where bounds are known
/// before.
#pragma once

#include "optimized/decide/vector3.h"

namespace type21::optimized {

/// Four doubles. Element by element the operations are those of one double: the same bits on any machine.
constexpr int lanes = 4;
using Lanes = double __attribute__((vector_size(lanes * sizeof(double))));

/// Numbers of a sub-triangle and of the node on it, one row a number, one column a lane.
struct PlainRows {
    enum Row {
        px,
        py,
        pz,  // the node
        ox,
        oy,
        oz,  // o, see LocalSegmentIn
        x1,
        y1,
        z1,
        x2,
        y2,
        z2,
        x3,
        y3,
        z3,  // the other corners
        bx,
        by,
        bz,
        cx,
        cy,
        cz,  // B, C
        l1x,
        l1y,
        l1z,
        l2x,
        l2y,
        l2z,
        l3x,
        l3y,
        l3z,
        l4x,
        l4y,
        l4z,  // normals whose mean is n_A
        nbx,
        nby,
        nbz,
        ncx,
        ncy,
        ncz,
        quarter,
        normal_quarter,  // of a quad; a triangle has 0 and 1
        in_count
    };
    enum Result { rb, rc, rlift, rnx, rny, rnz, rheight, rsquare, rtotal, rinner, rp, rq, rfar, out_count };
    alignas(64) double in[in_count][lanes];
    alignas(64) double out[out_count][lanes];
};

/// Fills out: b, c, lift = H / <n, N>, n, H, |N|^2, W of step 2, the smallest weight of step 2, p and q of the node,
/// and the largest |P - o|. Each is computed with the operations of filter(), in their order.
void plain_landing(PlainRows& rows);

}  // namespace type21::optimized
