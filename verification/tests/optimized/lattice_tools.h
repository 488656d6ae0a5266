// Tools and nodes on a lattice: numbers that decide are often exactly zero.
#pragma once

#include "verification/tests/optimized/test_tools.h"

namespace type21::optimized::testing {

/// Small tools whose segments mostly share the vertex 0. Normals are those of adjacent faces, or lie in the plane of
/// one, or know nothing of them.
class OnALattice {
  public:
    explicit OnALattice(unsigned seed) : random_(seed) {}

    Tool tool() {
        const int vertices = 5 + below(4), segments = 2 + below(5);
        std::vector<V3> position(static_cast<size_t>(vertices)), normal(position.size());
        for (V3& x : position)
            x = point(2);
        std::vector<std::array<int, 4>> corner;
        for (int s = 0; s < segments; ++s) {
            std::array<int, 4> of{below(3) == 0 ? below(vertices) : 0, below(vertices), below(vertices),
                                  below(vertices)};
            if (below(3) != 0) of[3] = of[2];
            corner.push_back(of);
        }
        // A triangle has its A last, and any corner may be the shared one.
        for (auto& of : corner) {
            const bool triangle = of[2] == of[3];
            std::rotate(of.begin(), of.begin() + below(3), of.begin() + 3);
            if (triangle) of[3] = of[2];
        }
        for (size_t v = 0; v < normal.size(); ++v)
            normal[v] = normal_at(static_cast<int>(v), position, corner);
        return {position, normal, corner};
    }
    /// Often exactly above a corner, over a side, or in the plane of a sub-triangle.
    V3 node(const Tool& tool) {
        const SegmentData s = tool.segment(below(tool.size()));
        std::array<V3, 5> x, n;
        for (size_t j = 0; j < 4; ++j) {
            x[j] = s.node[j];
            n[j] = s.normal[j];
        }
        x[4] = ((x[0] + x[1]) + (x[2] + x[3])) * 0.25;
        n[4] = ((n[0] + n[1]) + (n[2] + n[3])) * 0.25;
        const auto i = static_cast<size_t>(below(5)), j = static_cast<size_t>(below(5)),
                   k = static_cast<size_t>(below(5));
        const double height = 0.125 * (below(17) - 8), share = 0.25 * below(5), other = 0.25 * below(3);
        V3 y = x[i] + n[i] * height;
        switch (below(8)) {
            case 0:
            case 1:
                y = x[i] * (1 - share) + x[j] * share + (n[i] * (1 - share) + n[j] * share) * height;
                break;
            case 2:
                y = x[i] + (x[j] - x[i]) * share + (x[k] - x[i]) * other;
                break;
            case 3:
                y = point(4) * 0.5;
                break;
            default:
                break;
        }
        if (below(6) == 0) y = {std::nextafter(y.x, below(2) == 0 ? 9.0 : -9.0), y.y, y.z};
        return y;
    }
    int below(int end) { return static_cast<int>(random_() % static_cast<unsigned>(end)); }

  private:
    V3 point(int size) {
        const auto one = [&] { return double(below(2 * size + 1) - size); };
        const double x = one(), y = one();
        return {x, y, one()};
    }
    V3 normal_at(int vertex, const std::vector<V3>& position, const std::vector<std::array<int, 4>>& corner) {
        const auto x = [&](int v) { return position[static_cast<size_t>(v)]; };
        std::vector<std::array<V3, 2>> edges;  // of the faces at the vertex, from it
        for (const auto& of : corner) {
            const int count = of[2] == of[3] ? 3 : 4;
            for (int j = 0; j < count; ++j)
                if (of[static_cast<size_t>(j)] == vertex)
                    edges.push_back({x(of[static_cast<size_t>((j + 1) % count)]) - x(vertex),
                                     x(of[static_cast<size_t>((j + count - 1) % count)]) - x(vertex)});
        }
        if (edges.empty() || below(6) == 0) return point(1);
        const auto& one = edges[static_cast<size_t>(below(static_cast<int>(edges.size())))];
        switch (below(4)) {
            case 0:
                return one[0] * double(below(3) - 1) + one[1] * double(below(3) - 1);
            case 1:
                return cross(one[0], one[1]);
            default: {
                V3 sum;
                for (const auto& e : edges)
                    sum = sum + cross(e[0], e[1]);
                return sum;
            }
        }
    }
    std::mt19937_64 random_;
};

}  // namespace type21::optimized::testing
