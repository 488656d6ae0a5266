/// @file The tool in its own frame, built once.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "optimized/projection/segment.h"
#include "reference/contract/scene.h"

namespace type21::optimized {

/// The main surface with y = x - x_G at time 0 (Formulation 1, step 1). It never deforms.
/// @manual field surf_IDm, IDrby
class Tool {
  public:
    Tool(const ContactModel& model, const Interface& interface);
    /// As given: positions, normals taken as they are, segments into them.
    Tool(std::vector<V3> position, std::vector<V3> normal, std::vector<std::array<int, 4>> corner);

    int size() const { return static_cast<int>(corner_.size()); }
    SegmentData segment(int rank) const {
        const auto& corner = corner_[static_cast<size_t>(rank)];
        SegmentData s;
        for (size_t j = 0; j < 4; ++j) {
            const Vertex& vertex = vertex_[static_cast<size_t>(corner[j])];
            s.node[j] = vertex.position;
            s.normal[j] = vertex.normal;
        }
        s.is_triangle = corner[2] == corner[3];
        return s;
    }
    bool is_triangle(int rank) const {
        return corner_[static_cast<size_t>(rank)][2] == corner_[static_cast<size_t>(rank)][3];
    }
    bool triangles_only() const {
        return std::all_of(corner_.begin(), corner_.end(), [](const auto& c) { return c[2] == c[3]; });
    }
    /// Corners as ranks of vertices.
    const std::array<int, 4>& corner(int rank) const { return corner_[static_cast<size_t>(rank)]; }
    /// Largest |x_j - o| of a segment in the maximum norm, o as in LocalSegmentIn [length].
    double extent(int rank) const { return double(extent_[static_cast<size_t>(rank)]); }
    /// Position and normal of a corner.
    const V3& node(int rank, int j) const { return vertex(rank, j).position; }
    const V3& normal(int rank, int j) const { return vertex(rank, j).normal; }
    /// Position and normal of a corner, six numbers in a row.
    const double* numbers(int rank, int j) const { return &vertex(rank, j).position.x; }
    /// Prefetches the indices of a segment; then its vertices.
    void prefetch_segment(int rank) const {
        __builtin_prefetch(&corner_[static_cast<size_t>(rank)]);
        __builtin_prefetch(&extent_[static_cast<size_t>(rank)]);
    }
    void prefetch_corners(int rank) const {
        for (const int v : corner_[static_cast<size_t>(rank)])
            __builtin_prefetch(&vertex_[static_cast<size_t>(v)]);
    }
    size_t bytes() const {
        return vertex_.capacity() * sizeof(Vertex) + corner_.capacity() * sizeof(corner_[0]) +
               extent_.capacity() * sizeof(float);
    }

  private:
    /// One cache line.
    struct alignas(64) Vertex {
        V3 position;  ///< [length]
        V3 normal;    ///< [-]
    };
    static_assert(offsetof(Vertex, normal) == 3 * sizeof(double));
    const Vertex& vertex(int rank, int j) const {
        return vertex_[static_cast<size_t>(corner_[static_cast<size_t>(rank)][static_cast<size_t>(j)])];
    }
    void find_extents();

    std::vector<Vertex> vertex_;
    std::vector<std::array<int, 4>> corner_;
    std::vector<float> extent_;  ///< rounded up
};

/// Nodal normals: the sum of the unit normals of the adjacent sub-triangles, normalised; zero where the sum is zero.
/// The sums run in the order of the segments and of the sub-triangles: that order is part of what a decision is exact
/// for. Source: Formulation 1, step 4.
/// @manual field surf_IDm
std::vector<V3> nodal_normals(const std::vector<V3>& position, const std::vector<std::array<int, 4>>& corner);

}  // namespace type21::optimized
