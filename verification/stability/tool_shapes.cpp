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

/// Segments over a grid of (elements + 1)^2 nodes, x fastest.
std::vector<std::array<int, 4>> grid(bool triangles) {
    std::vector<std::array<int, 4>> segments;
    const auto at = [](int i, int j) { return j * (elements + 1) + i; };
    for (int j = 0; j < elements; ++j) {
        for (int i = 0; i < elements; ++i) {
            const std::array<int, 4> q{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)};
            if (triangles) {
                segments.push_back({q[0], q[1], q[2], q[2]});
                segments.push_back({q[0], q[2], q[3], q[3]});
            } else {
                segments.push_back(q);
            }
        }
    }
    return segments;
}

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

Tool make_tool(Shape shape, Mesh mesh) {
    Tool tool;
    Scatter scatter;
    const double half = 0.5 * elements;
    for (int j = 0; j <= elements; ++j) {
        for (int i = 0; i <= elements; ++i) {
            double s = (i - half) * element_size;
            double y = (j - half) * element_size;
            double off = 0;
            if (mesh == Mesh::distorted) {
                s += 0.25 * element_size * scatter();
                y += 0.25 * element_size * scatter();
            } else if (mesh == Mesh::warped) {
                off = (i + j) % 2 == 0 ? warp : -warp;
            }
            tool.node.push_back(over(shape, s, y, off));
        }
    }
    tool.segment = grid(mesh == Mesh::triangle);
    return tool;
}

Tool make_fold(bool convex, double slope, double ridge) {
    Tool tool;
    const double half = 0.5 * elements;
    for (int j = 0; j <= elements; ++j) {
        for (int i = 0; i <= elements; ++i) {
            const double x = (i - half) * element_size;
            const double height = std::tan(slope) * std::abs(x);
            tool.node.emplace_back(x + ridge, (j - half) * element_size, convex ? -height : height);
        }
    }
    tool.segment = grid(false);
    return tool;
}

}  // namespace type21::stability
