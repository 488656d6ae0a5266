/// @file Projection of a node on one sub-triangle along interpolated normals (chapter 3 of the formulation).
/// Only + - x / and comparisons: the text is the same for double and for exact numbers.
#pragma once

#include <optional>

#include "reference/contact/sub_triangle.h"

namespace type21::reference {

// Two functions that do not decide: their value is continuous where they branch. A type that only encloses its value
// overloads them, so that they never ask it for an answer.

/// |value|
template <class Number>
Number magnitude(const Number& value) {
    return value < Number(0) ? Number(-value) : value;
}

/// The nearest number in [0, 1].
template <class Number>
Number clipped(const Number& value) {
    if (value < Number(0)) return Number(0);
    return value > Number(1) ? Number(1) : value;
}

/// Bounds of the weights, and what happens to a normal that does not face outward.
/// Formulation 3, step 1; Formulation 3, step 2.
template <class Number>
struct ProjectionLimits {
    Number low = Number(-0.01);  ///< a weight below it is outside; the double nearest to -0.01
    Number high = Number(1.01);  ///< b + c above it is outside; the double nearest to 1.01
    bool lift_leaning = false;   ///< <n_V, N> <= 0 is raised and does not reject (as built: D35)
};

/// Weights of a point in a triangle; a = 1 - b - c.
template <class Number>
struct Barycentric {
    Number b{0};
    Number c{0};
};

/// Result of an accepted projection.
template <class Number>
struct Projection {
    Barycentric<Number> weights;                     ///< of Q in A B C, unclipped [-]
    Vector<Number> normal = Vector<Number>::Zero();  ///< n, interpolated at the lifted triangle, not of unit length [-]
    Number height{0};                                ///< H = <P - A, N> [length^3]
    Number slope{0};                                 ///< <n, N>, > 0 [length^2]
};

/// Weights of a point in (A, B, C) whose area vector is `area`:
///   b = -<N, (A - Q) x (C - Q)> / |N|^2,   c = <N, (A - Q) x (B - Q)> / |N|^2
/// @param q     the point, in the plane of the triangle [length]
/// @param area  N, not zero [length^2]
/// @return b and c [-].  Formulation 3, step 2.
template <class Number>
Barycentric<Number> barycentric(const Vector<Number>& q, const Vector<Number>& a, const Vector<Number>& b,
                                const Vector<Number>& c, const Vector<Number>& area) {
    const Number square = area.dot(area);
    const Vector<Number> qa = a - q;
    const Vector<Number> qb = b - q;
    const Vector<Number> qc = c - q;
    const Vector<Number> ac = qa.cross(qc);
    const Vector<Number> ab = qa.cross(qb);
    const Number along_b = area.dot(ac);
    const Number along_c = area.dot(ab);
    return {-along_b / square, along_c / square};
}

/// Whether a point counts as inside, with the margin of the limits.  Formulation 3, step 2.
template <class Number>
bool inside(const Barycentric<Number>& w, const ProjectionLimits<Number>& limits) {
    const Number sum = w.b + w.c;
    return !(w.b < limits.low) && !(w.c < limits.low) && !(sum > limits.high);
}

/// The numbers that decide, in the order in which they are met. The one met last is the one that rejected.
enum class ProjectionStep {
    height,          ///< H
    corner_slopes,   ///< <n_A,N>, <n_B,N>, <n_C,N>
    turn,            ///< <M,N>
    lifted_weights,  ///< b', c'
    slope,           ///< <n,N>
    weights          ///< b, c
};

/// Default trace: records nothing.
struct NoTrace {
    template <class... Number>
    void operator()(ProjectionStep, const Number&...) const {}
};

/// <n_A, N>, <n_B, N>, <n_C, N>: above 0 where a corner normal faces outward [length^2].
template <class Number>
struct CornerSlopes {
    Number a, b, c;

    bool all_positive() const { return a > Number(0) && b > Number(0) && c > Number(0); }
    /// D35: a normal that does not face outward is lifted with a tiny slope in its place.
    /// @manual departure D35
    void raise() {
        const Number tiny(1e-30);
        if (a < tiny) a = tiny;
        if (b < tiny) b = tiny;
        if (c < tiny) c = tiny;
    }
};

/// The corners of a lifted sub-triangle [length].
template <class Number>
struct LiftedTriangle {
    Vector<Number> a, b, c;
};

/// Lifts A, B, C along their normals to the plane through P that is parallel to the sub-triangle. A node on its plane
/// (H = 0) lifts nothing, and a normal that does not face outward does not matter to it.
/// @param height  H = <P - A, N> [length^3]
/// @return nothing where a normal does not face outward.  Formulation 3, step 1; as built: D35.
template <class Number>
std::optional<LiftedTriangle<Number>> lift(const SubTriangle<Number>& t, const Number& height,
                                           CornerSlopes<Number> slopes, const ProjectionLimits<Number>& limits) {
    const bool rises = slopes.all_positive();
    if (!rises && height == Number(0)) return LiftedTriangle<Number>{t.a, t.b, t.c};
    if (!rises && !limits.lift_leaning) return std::nullopt;
    if (!rises) slopes.raise();
    LiftedTriangle<Number> lifted{t.a, t.b, t.c};
    lifted.a += t.normal_a * (height / slopes.a);
    lifted.b += t.normal_b * (height / slopes.b);
    lifted.c += t.normal_c * (height / slopes.c);
    return lifted;
}

/// Projects P on the sub-triangle: lift the triangle to the node's height along the corner normals, read the weights
/// there, interpolate the normal with them, and follow it down to the triangle.
/// @param p      the node [length]
/// @param t      the sub-triangle in the same frame
/// @param trace  called with each ProjectionStep and its numbers
/// @return nothing where the sub-triangle rejects the node.  Formulation 3, step 1 to step 3.
/// @throws what Number throws where it cannot tell; double throws nothing
template <class Number, class Trace = NoTrace>
std::optional<Projection<Number>> project(const Vector<Number>& p, const SubTriangle<Number>& t,
                                          const ProjectionLimits<Number>& limits, Trace&& trace = Trace()) {
    const Number zero(0);

    // Formulation 3, step 1: lift the corners to the height of the node.
    const Vector<Number> ap = p - t.a;
    const Number height = ap.dot(t.area);
    trace(ProjectionStep::height, height);
    const CornerSlopes<Number> slopes{t.normal_a.dot(t.area), t.normal_b.dot(t.area), t.normal_c.dot(t.area)};
    trace(ProjectionStep::corner_slopes, slopes.a, slopes.b, slopes.c);
    const auto lifted = lift(t, height, slopes, limits);
    if (!lifted) return std::nullopt;

    // Formulation 3, step 2: the lifted triangle must not be turned over, and P must lie in it.
    const Vector<Number> lifted_ab = lifted->b - lifted->a;
    const Vector<Number> lifted_ac = lifted->c - lifted->a;
    const Vector<Number> lifted_area = lifted_ab.cross(lifted_ac);
    const Number turn = lifted_area.dot(t.area);
    trace(ProjectionStep::turn, turn);
    if (!(turn > zero)) return std::nullopt;
    const Barycentric<Number> first = barycentric(p, lifted->a, lifted->b, lifted->c, lifted_area);
    trace(ProjectionStep::lifted_weights, first.b, first.c);
    if (!inside(first, limits)) return std::nullopt;

    // Formulation 3, step 3: follow the interpolated normal down to the triangle.
    const Number first_a = Number(1) - first.b - first.c;
    const Vector<Number> normal = t.normal_a * first_a + t.normal_b * first.b + t.normal_c * first.c;
    const Number slope = normal.dot(t.area);
    trace(ProjectionStep::slope, slope);
    if (!(slope > zero)) return std::nullopt;
    const Vector<Number> q = p - normal * (height / slope);
    const Barycentric<Number> weights = barycentric(q, t.a, t.b, t.c, t.area);
    trace(ProjectionStep::weights, weights.b, weights.c);
    if (!inside(weights, limits)) return std::nullopt;
    return Projection<Number>{weights, normal, height, slope};
}

/// Distance for the acceptance test: to the point whose weights are clipped to [0, 1] and rescaled to the sum 1.
template <class Number>
struct Approach {
    Number squared_distance{0};  ///< d^2 [length^2]
    int side = +1;               ///< +1 outward of the plane or on it, -1 behind
};

/// @param p  the node [length]
/// @param w  its weights on t, unclipped.  Formulation 3, step 4.
template <class Number>
Approach<Number> approach(const Vector<Number>& p, const SubTriangle<Number>& t, const Barycentric<Number>& w) {
    const Number a = clipped(Number(Number(1) - w.b - w.c));
    const Number b = clipped(w.b);
    const Number c = clipped(w.c);
    const Number sum = a + b + c;
    const Vector<Number> nearest = (t.a * a + t.b * b + t.c * c) / sum;
    const Vector<Number> offset = p - nearest;
    const Number outward = offset.dot(t.area);
    return {offset.dot(offset), outward < Number(0) ? -1 : +1};
}

/// kappa = |1/3 - b| + |1/3 - c| + |2/3 - b - c|: 0 at the centroid [-].  Formulation 3, step 6.
template <class Number>
Number centrality(const Barycentric<Number>& w) {
    const Number third = Number(1) / Number(3);
    const Number to_b = third - w.b;
    const Number to_c = third - w.c;
    const Number to_a = third + third - w.b - w.c;
    return magnitude(to_b) + magnitude(to_c) + magnitude(to_a);
}

}  // namespace type21::reference
