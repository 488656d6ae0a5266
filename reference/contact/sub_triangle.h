/// @file The pieces of a segment on which a node is projected (Formulation 1, step 3; Formulation 1, step 5).
#pragma once

#include <array>

#include "reference/contract/vector.h"

namespace type21::reference {

/// A segment with the nodal normals of the tool, all in the tool frame. A triangle repeats its third node.
template <class Number>
struct SegmentShape {
    std::array<Vector<Number>, 4> node;    ///< x_j [length]
    std::array<Vector<Number>, 4> normal;  ///< n_j, unit to rounding [-]
    bool triangle = false;

    int sub_triangles() const { return triangle ? 1 : 4; }
};

/// One sub-triangle (A, B, C) with the normals at its corners.
template <class Number>
struct SubTriangle {
    Vector<Number> a, b, c;             ///< corners [length]
    Vector<Number> normal_a;            ///< normal at A; of a quad a mean and not of unit length [-]
    Vector<Number> normal_b, normal_c;  ///< normals at B and C [-]
    Vector<Number> area;                ///< N = (B - A) x (C - A), twice the area, outward [length^2]
};

/// Mean of four, with one division: the exact mean when Number is exact.
template <class Number>
Vector<Number> mean(const std::array<Vector<Number>, 4>& four) {
    return (four[0] + four[1] + four[2] + four[3]) / Number(4);
}

/// Sub-triangle k of a segment: quad (A, x_k, x_{k+1}) round A = mean of its nodes; triangle A = x_3, B = x_1, C = x_2.
/// @param k  1..4 for a quad, 1 for a triangle; not checked
/// @return corners, normals and area vector; the normal at A of a quad is the plain mean.
/// Formulation 1, step 3; Formulation 1, step 5.
template <class Number>
SubTriangle<Number> sub_triangle(const SegmentShape<Number>& segment, int k) {
    SubTriangle<Number> t;
    if (segment.triangle) {
        t.a = segment.node[2];
        t.b = segment.node[0];
        t.c = segment.node[1];
        t.normal_a = segment.normal[2];
        t.normal_b = segment.normal[0];
        t.normal_c = segment.normal[1];
    } else {
        const size_t first = static_cast<size_t>(k - 1);
        const size_t second = static_cast<size_t>(k % 4);
        t.a = mean(segment.node);
        t.b = segment.node[first];
        t.c = segment.node[second];
        t.normal_a = mean(segment.normal);
        t.normal_b = segment.normal[first];
        t.normal_c = segment.normal[second];
    }
    t.area = (t.b - t.a).cross(t.c - t.a);
    return t;
}

}  // namespace type21::reference
