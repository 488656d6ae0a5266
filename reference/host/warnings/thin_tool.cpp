/// @file A tool with two faces that is thinner than DEPTH: a node at one face is within reach of the other.
#include <algorithm>
#include <limits>
#include <numeric>
#include <unsupported/Eigen/BVH>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"

namespace type21 {
namespace {

size_t at(int index) {
    return static_cast<size_t>(index);
}

/// Middle and unit normal of a segment.
struct Face {
    Vec3 middle = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double area = 0;
    double radius = 0;  ///< of a ball about the middle that holds the segment [length]
};

std::vector<Face> faces_of(const Surface& surface, const std::vector<Vec3>& x) {
    std::vector<Face> faces;
    faces.reserve(surface.segments.size());
    for (const Segment& segment : surface.segments) {
        const auto& n = segment.node;
        Face& face = faces.emplace_back();
        for (int corner = 0; corner < segment.corners(); ++corner)
            face.middle += x[at(n[at(corner)])] / segment.corners();
        for (const int node : n)
            face.radius = std::max(face.radius, (x[at(node)] - face.middle).norm());
        const Vec3 area = 0.5 * (x[at(n[2])] - x[at(n[0])]).cross(x[at(n[3])] - x[at(n[1])]);
        face.area = area.norm();
        if (face.area > 0) face.normal = area / face.area;
    }
    return faces;
}

/// All faces look into one cone of 60 degrees: no two can be the two sides of one wall.
bool looks_one_way(const std::vector<Face>& faces) {
    Vec3 mean = Vec3::Zero();
    for (const Face& face : faces)
        mean += face.area * face.normal;
    if (!(mean.norm() > 0)) return false;
    mean.normalize();
    return std::all_of(faces.begin(), faces.end(), [&](const Face& face) { return face.normal.dot(mean) > 0.5; });
}

using Box = Eigen::AlignedBox3d;
using FaceTree = Eigen::KdBVH<double, 3, int>;

FaceTree tree_of(const std::vector<Face>& faces) {
    std::vector<int> indices(faces.size());
    std::iota(indices.begin(), indices.end(), 0);
    std::vector<Box> boxes;
    boxes.reserve(faces.size());
    for (const Face& face : faces)
        boxes.emplace_back(face.middle - Vec3::Constant(face.radius), face.middle + Vec3::Constant(face.radius));
    return FaceTree(indices.begin(), indices.end(), boxes.begin(), boxes.end());
}

/// Hands on the faces whose boxes meet a box.
template <class Visit>
struct FacesNear {
    Box box;
    Visit visit;
    bool intersectVolume(const Box& other) const { return box.intersects(other); }
    bool intersectObject(int face) const {
        visit(face);
        return false;  // go on
    }
};

struct ThinWall {
    int segments = 0;  ///< with another face behind them, nearer than DEPTH
    int first = -1;
    int behind = -1;       ///< that face
    double thickness = 0;  ///< smallest [length]
};

/// How far behind the middle of `front` the plane of `back` lies, if they are the two faces of one wall; else infinite.
double wall_thickness(const Face& front, const Face& back) {
    constexpr double none = std::numeric_limits<double>::infinity();
    constexpr double opposite = -0.5;
    const double facing = front.normal.dot(back.normal);
    if (facing > opposite) return none;
    const double depth = (back.middle - front.middle).dot(back.normal) / -facing;
    if (depth < 0) return none;
    const Vec3 hit = front.middle - depth * front.normal;
    if ((hit - back.middle).norm() > back.radius) return none;
    return depth;
}

ThinWall thin_wall(const std::vector<Face>& faces, double reach) {
    const FaceTree tree = tree_of(faces);
    ThinWall wall;
    for (int i = 0; i < static_cast<int>(faces.size()); ++i) {
        const Face& front = faces[at(i)];
        double thinnest = std::numeric_limits<double>::infinity();
        int behind = -1;
        const auto look = [&](int other) {
            if (other == i) return;
            const double thickness = wall_thickness(front, faces[at(other)]);
            if (thickness >= reach || thickness >= thinnest) return;
            thinnest = thickness;
            behind = other;
        };
        Box way(front.middle);
        way.extend(Vec3(front.middle - reach * front.normal));
        FacesNear<decltype(look)> query{way, look};
        Eigen::BVIntersect(tree, query);
        if (behind < 0) continue;
        if (wall.segments++ == 0 || thinnest < wall.thickness) {
            wall.thickness = thinnest;
            wall.first = i;
            wall.behind = behind;
        }
    }
    return wall;
}

}  // namespace

void warn_of_thin_tools(const SurpriseCheck& check) {
    for (const Interface& interface : check.model.interfaces) {
        const Surface& surface = check.main_surface(interface);
        const std::vector<Face> faces = faces_of(surface, check.model.nodes.position);
        if (!(interface.depth > 0) || looks_one_way(faces)) continue;
        const ThinWall wall = thin_wall(faces, interface.depth);
        if (wall.segments == 0) continue;
        check.at_interface(
            interface, "DEPTH", check.quantity(interface.depth, dim::length),
            fmt::format("the tool has two faces and is only {} thick at segment {} (nodes {}): a node at one face lies "
                        "within DEPTH behind the other and may be held by it; {} segment{} in all",
                        check.quantity(wall.thickness, dim::length), wall.first + 1,
                        check.nodes_of(surface.segments[at(wall.first)]), wall.segments,
                        wall.segments == 1 ? " is so" : "s are so"),
            "Give the interface the face that touches the blank only, or a DEPTH below the thickness of the tool");
    }
}

}  // namespace type21
