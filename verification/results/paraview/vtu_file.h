/// @file One unstructured grid in the XML form of VTK (.vtu): a mesh of shells and values at its points and cells.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "reference/contract/vector.h"

namespace type21 {

/// Values of one name, one tuple a point or cell.
struct VtuArray {
    std::string name;
    std::string unit;  ///< "mm"; empty for a pure number
    int components = 1;
    std::variant<std::vector<double>, std::vector<std::int64_t>> values;
};

/// A quad, or a triangle whose fourth point is its third: indices into VtuGrid::points.
using VtuCell = std::array<std::int64_t, 4>;

struct VtuGrid {
    double time = 0;           ///< [time]
    std::string time_unit;     ///< "s"
    std::string length_unit;   ///< of the points: "mm"
    std::vector<Vec3> points;  ///< [length]
    std::vector<VtuCell> cells;
    std::vector<VtuArray> point_arrays, cell_arrays;
};

/// Writes doubles as they are, in base64. Field data of the grid hold the time (TimeValue) and one text for each array
/// with its unit (units). The file appears in one move: a reader never meets half of it.
/// @param mark  a line of XML that says which run wrote it, or nothing
/// @throws IoError
void write_vtu(const std::filesystem::path& path, const VtuGrid& grid, const std::string& mark = "");

}  // namespace type21
