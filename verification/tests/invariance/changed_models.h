/// @file The same scene described in another way: turned, mirrored, moved, renumbered.
#pragma once

#include <array>
#include <random>
#include <vector>

#include "reference/model/model.h"

namespace type21::test {

/// A map of the axes onto each other: axis d becomes sign[d] times axis to[d]. All products with it are exact.
struct AxisMap {
    std::array<int, 3> to{0, 1, 2};
    std::array<double, 3> sign{1, 1, 1};

    Vec3 operator()(const Vec3& v) const;
    double determinant() const;
};

inline const AxisMap identity{};
inline const AxisMap cyclic{{1, 2, 0}, {1, 1, 1}};         ///< x to y to z to x: a turn of 120 degrees about (1, 1, 1)
inline const AxisMap quarter_turn{{1, 0, 2}, {1, -1, 1}};  ///< x to y, y to -x: 90 degrees about z
inline const AxisMap mirror{{0, 1, 2}, {1, -1, 1}};        ///< y to -y

/// Mesh, loads, imposed motions, conditions and tools in other axes. A mirror lists the corners of each segment the
/// other way round, so that outward stays outward.
Model mapped(Model model, const AxisMap& map);

/// Everything moved.
Model moved(Model model, const Vec3& by);

/// All coordinates rounded to multiples of 2^-24, so that they can be moved by some thousand without rounding.
Model on_a_grid(Model model);

/// Ids 7 id + 3: another numbering in the same order.
Model with_other_ids(Model model);

/// The nodes in another order; index n becomes order[n].
Model with_nodes_in_order(const Model& model, const std::vector<int>& order);
std::vector<int> shuffled(int count, unsigned seed);

/// The main segments of each interface in reverse order.
Model with_main_segments_reversed(Model model);

}  // namespace type21::test
