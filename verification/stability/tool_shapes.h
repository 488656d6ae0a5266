/// @file Tools of the long runs and sliding paths: plane, cylinders and folds, each with meshes from plain to bad.
#pragma once

#include <string_view>

#include "verification/support/scene_builder.h"

namespace type21::stability {

enum class Shape { flat, convex, concave };

enum class Mesh {
    quad,       ///< along the axis of the cylinder: plane quads
    triangle,   ///< each of these quads cut along one diagonal
    distorted,  ///< the nodes shifted along the surface by up to a quarter of an element
    warped      ///< the nodes shifted off the surface, up and down in turn: saddles
};

std::string_view name(Shape shape);
std::string_view name(Mesh mesh);

inline constexpr double cylinder_radius = 10.0;  ///< [mm]
inline constexpr double element_size = 2.0;      ///< [mm]
inline constexpr double warp = 0.05;             ///< of the nodes of Mesh::warped, to both sides [mm]

/// The point at this distance over the smooth surface: arc s and y along it, distance outward; all [mm].
/// The cylinder's axis is parallel to y. Convex: it lies below, the tool is its outside; concave: above, its inside.
Vec3 over(Shape shape, double s, double y, double distance);

/// A patch of 10 x 10 elements (or twice as many triangles), 20 mm wide, its middle in the origin. Outward is up.
SurfaceMesh make_tool(Shape shape, Mesh mesh);

/// Two planes that meet in the line x = ridge, each sloping by `slope` [rad] away from it: down (convex) or up
/// (concave).
SurfaceMesh make_fold(bool convex, double slope, double ridge);

}  // namespace type21::stability
