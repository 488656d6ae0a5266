#include "verification/results/paraview/vtu_file.h"

#include <bit>
#include <pugixml.hpp>
#include <sstream>

#include <fmt/format.h>

#include "verification/results/paraview/base64.h"
#include "verification/support/output_file.h"

namespace type21 {
namespace {

constexpr int vtk_triangle = 5, vtk_quad = 9;

template <class Number>
const char* type_name();
template <>
const char* type_name<double>() {
    return "Float64";
}
template <>
const char* type_name<std::int64_t>() {
    return "Int64";
}
template <>
const char* type_name<std::uint8_t>() {
    return "UInt8";
}

pugi::xml_node data_array(pugi::xml_node parent, const char* type, const std::string& name, int components) {
    pugi::xml_node node = parent.append_child("DataArray");
    node.append_attribute("type") = type;
    node.append_attribute("Name") = name.c_str();
    node.append_attribute("NumberOfComponents") = components;
    return node;
}

/// The number of bytes and the bytes, encoded as one.
template <class Number>
pugi::xml_node append(pugi::xml_node parent, const std::string& name, int components,
                      const std::vector<Number>& values) {
    pugi::xml_node node = data_array(parent, type_name<Number>(), name, components);
    node.append_attribute("format") = "binary";
    const std::uint64_t bytes = values.size() * sizeof(Number);
    std::string block(reinterpret_cast<const char*>(&bytes), sizeof bytes);
    block.append(reinterpret_cast<const char*>(values.data()), bytes);
    node.text().set(base64(block.data(), block.size()).c_str());
    return node;
}

void append(pugi::xml_node parent, const std::vector<VtuArray>& arrays) {
    for (const VtuArray& array : arrays)
        std::visit([&](const auto& values) { append(parent, array.name, array.components, values); }, array.values);
}

/// Texts as VTK stores them: the numbers of their characters, each text closed by a 0.
void append_texts(pugi::xml_node parent, const std::string& name, const std::vector<std::string>& texts) {
    pugi::xml_node node = data_array(parent, "String", name, 1);
    node.append_attribute("NumberOfTuples") = texts.size();
    node.append_attribute("format") = "ascii";
    std::string numbers;
    for (const std::string& text : texts) {
        for (const char c : text)
            numbers += fmt::format("{} ", static_cast<unsigned char>(c));
        numbers += "0 ";
    }
    node.text().set(numbers.c_str());
}

std::vector<std::string> units_of(const VtuGrid& grid) {
    std::vector<std::string> units{fmt::format("time [{}]", grid.time_unit),
                                   fmt::format("points [{}]", grid.length_unit)};
    for (const auto* arrays : {&grid.point_arrays, &grid.cell_arrays})
        for (const VtuArray& array : *arrays)
            units.push_back(fmt::format("{} [{}]", array.name, array.unit.empty() ? "-" : array.unit));
    return units;
}

void append_cells(pugi::xml_node piece, const std::vector<VtuCell>& cells) {
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    for (const VtuCell& cell : cells) {
        const bool is_triangle = cell[2] == cell[3];
        connectivity.insert(connectivity.end(), cell.begin(), cell.end() - (is_triangle ? 1 : 0));
        offsets.push_back(static_cast<std::int64_t>(connectivity.size()));
        types.push_back(static_cast<std::uint8_t>(is_triangle ? vtk_triangle : vtk_quad));
    }
    pugi::xml_node node = piece.append_child("Cells");
    append(node, "connectivity", 1, connectivity);
    append(node, "offsets", 1, offsets);
    append(node, "types", 1, types);
}

pugi::xml_document document(const VtuGrid& grid) {
    pugi::xml_document xml;
    pugi::xml_node root = xml.append_child("VTKFile");
    root.append_attribute("type") = "UnstructuredGrid";
    root.append_attribute("version") = "1.0";
    root.append_attribute("byte_order") = std::endian::native == std::endian::little ? "LittleEndian" : "BigEndian";
    root.append_attribute("header_type") = "UInt64";
    pugi::xml_node unstructured = root.append_child("UnstructuredGrid");
    pugi::xml_node field = unstructured.append_child("FieldData");
    append(field, "TimeValue", 1, std::vector<double>{grid.time}).append_attribute("NumberOfTuples") = 1;
    append_texts(field, "units", units_of(grid));
    pugi::xml_node piece = unstructured.append_child("Piece");
    piece.append_attribute("NumberOfPoints") = grid.points.size();
    piece.append_attribute("NumberOfCells") = grid.cells.size();
    append(piece.append_child("PointData"), grid.point_arrays);
    append(piece.append_child("CellData"), grid.cell_arrays);
    std::vector<double> points;
    for (const Vec3& point : grid.points)
        points.insert(points.end(), point.data(), point.data() + 3);
    append(piece.append_child("Points"), "points", 3, points);
    append_cells(piece, grid.cells);
    return xml;
}

}  // namespace

void write_vtu(const std::filesystem::path& path, const VtuGrid& grid, const std::string& mark) {
    std::ostringstream text;
    text << "<?xml version=\"1.0\"?>\n" << mark;
    document(grid).save(text, " ", pugi::format_default | pugi::format_no_declaration);
    replace_file(path, text.view());
}

}  // namespace type21
