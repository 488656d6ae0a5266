/// @file Contact with plain facet normals, for comparison: the nearest facet and its own normal, nothing interpolated.
#pragma once

#include "verification/stability/tool_shapes.h"

namespace type21::stability {

struct FacetForce {
    Vec3 normal = Vec3::Zero();    ///< k p n on the node [N]
    Vec3 friction = Vec3::Zero();  ///< on the tool, full slip: mu k p along the motion in the facet's plane [N]
};

/// Facets are the sub-triangles of the method (a quad: four about its middle), so that both see the same surface.
class FacetContact {
  public:
    explicit FacetContact(const SurfaceMesh& tool);
    /// The force on a node at x [mm], with p = g - distance to the nearest facet along its normal.
    /// @param travel    of the node in this step, any length [mm]
    /// @param friction  mu [-]
    FacetForce at(const Vec3& x, const Vec3& travel, double friction) const;

  private:
    struct Facet {
        Vec3 a, b, c, normal;
    };
    std::vector<Facet> facets_;
};

/// The point of triangle a b c nearest to p.
Vec3 nearest_point(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace type21::stability
