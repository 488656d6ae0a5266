#include "verification/stability/tool_shapes.h"

#include <cmath>

namespace type21::stability {
namespace {

constexpr int elements = 10;  ///< along each side

/// Numbers between -1 and 1 without a pattern, the same on every machine: a linear congruential sequence.
class Scatter {
  public:
    double operator()() {
        state_ = (state_ * 1103515245U + 12345U) % 2147483648U;
        return static_cast<double>(state_) / 1073741824.0 - 1.0;
    }

  private:
    unsigned state_ = 21;
};

}  // namespace

std::string_view name(Shape shape) {
    switch (shape) {
        case Shape::flat:
            return "flat";
        case Shape::convex:
            return "convex";
        case Shape::concave:
            return "concave";
    }
    return "";
}

std::string_view name(Mesh mesh) {
    switch (mesh) {
        case Mesh::quad:
            return "quad";
        case Mesh::triangle:
            return "triangle";
        case Mesh::distorted:
            return "distorted";
        case Mesh::warped:
            return "warped";
    }
    return "";
}

Vec3 over(Shape shape, double s, double y, double distance) {
    if (shape == Shape::flat) return {s, y, distance};
    const double angle = s / cylinder_radius;
    const double sign = shape == Shape::convex ? 1.0 : -1.0;
    const double radius = cylinder_radius + sign * distance;
    return {radius * std::sin(angle), y, sign * (radius * std::cos(angle) - cylinder_radius)};
}

SurfaceMesh make_tool(Shape shape, Mesh mesh) {
    Scatter scatter;
    const double half = 0.5 * elements;
    SurfaceMesh tool = grid(elements, elements, [&](int i, int j) {
        double s = (i - half) * element_size;
        double y = (j - half) * element_size;
        double off = 0;
        if (mesh == Mesh::distorted) {
            s += 0.25 * element_size * scatter();
            y += 0.25 * element_size * scatter();
        } else if (mesh == Mesh::warped) {
            off = (i + j) % 2 == 0 ? warp : -warp;
        }
        return over(shape, s, y, off);
    });
    if (mesh == Mesh::triangle) tool.segment = split_quads(tool.segment);
    return tool;
}

SurfaceMesh make_fold(bool convex, double slope, double ridge) {
    const double half = 0.5 * elements;
    return grid(elements, elements, [&](int i, int j) {
        const double x = (i - half) * element_size;
        const double height = std::tan(slope) * std::abs(x);
        return Vec3(x + ridge, (j - half) * element_size, convex ? -height : height);
    });
}

}  // namespace type21::stability
