/// @file The nearest point of a surface, by what others offer. Not TYPE21's question (it retains the most central
/// projection, not the nearest), but the work that a user would otherwise do, so a measure of speed.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "reference/contract/vector.h"

namespace type21::bench {

/// A surface in its own frame; a triangle repeats its third node, a quad stands for its four sub-triangles round the
/// mean of its corners.
struct SurfaceMesh {
    std::vector<Vec3> node;                   ///< [length]
    std::vector<std::array<int, 4>> segment;  ///< into node

    /// Corners of each sub-triangle.
    std::vector<std::array<Vec3, 3>> triangles() const;
};

struct Nearest {
    double distance2 = 0;  ///< [length^2]
    int segment = -1;      ///< -1: none within reach
};

/// Squared distance from p to a triangle, and nothing else.
double distance2_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

class ClosestPoint {
  public:
    virtual ~ClosestPoint() = default;
    virtual Nearest at(const Vec3& p) const = 0;
    /// That it holds, as far as it can be known.
    virtual size_t bytes() const = 0;
};

/// Asks every triangle: the truth of tests.
std::unique_ptr<ClosestPoint> closest_by_force(const SurfaceMesh& mesh);
/// False in a program that was built without Embree.
bool has_embree();
/// Embree 3 or 4, its point query over a tree in single precision, with our callback in double.
/// @param reach  nothing farther is looked for [length]
std::unique_ptr<ClosestPoint> closest_by_embree(const SurfaceMesh& mesh, double reach);
/// CGAL's AABB tree with the kernels Simple_cartesian<double> and EPICK.
std::unique_ptr<ClosestPoint> closest_by_cgal_double(const SurfaceMesh& mesh);
std::unique_ptr<ClosestPoint> closest_by_cgal_epick(const SurfaceMesh& mesh);

}  // namespace type21::bench
