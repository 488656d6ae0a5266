#include "reference/deck/foreign_format.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "reference/deck/text_file.h"

namespace type21 {

namespace {

using namespace std::string_view_literals;

using Name = std::pair<std::string_view, std::string_view>;  ///< what a file begins with, and what it is then

constexpr auto binary_beginnings = std::to_array<Name>({
    {"\x1f\x8b"sv, "a file packed by gzip: unpack it first"},
    {"BZh"sv, "a file packed by bzip2: unpack it first"},
    {"\xfd\x37zXZ\0"sv, "a file packed by xz: unpack it first"},
    {"\x28\xb5\x2f\xfd"sv, "a file packed by zstd: unpack it first"},
    {"PK\x03\x04"sv, "a zip archive (or an office document): unpack it first"},
    {"7z\xbc\xaf\x27\x1c"sv, "a 7-Zip archive: unpack it first"},
    {"Rar!"sv, "a rar archive: unpack it first"},
    {"%PDF"sv, "a PDF document"},
    {"\x89PNG"sv, "a PNG picture"},
    {"\xff\xd8\xff"sv, "a JPEG picture"},
    {"GIF8"sv, "a GIF picture"},
    {"\x89HDF\r\n"sv, "an HDF5 file"},
    {"SQLite format 3"sv, "an SQLite database"},
    {"\x7f\x45LF"sv, "a program"},
    {"MZ\x90"sv, "a program"},
    {"\xff\xfe"sv, "text in UTF-16: save it as ASCII or UTF-8"},
    {"\xfe\xff"sv, "text in UTF-16: save it as ASCII or UTF-8"},
    // Records of Radioss: length 84 before a time history's code and title, or the magic number of an animation file.
    {"\0\0\0\x54\0\0"sv, "a time history file of Radioss (T01)"},
    {"\0\0\x54\x2c"sv, "an animation file of Radioss (A001)"},
    {"\0\0\x54\x2d"sv, "an animation file of Radioss (A001)"},
    {"\0\0\x54\x2e"sv, "an animation file of Radioss (A001)"},
    {"\0\0\x54\x2f"sv, "an animation file of Radioss (A001)"},
    {"\xd0\xcf\x11\xe0"sv, "an office document"},
    {"glTF"sv, "a glTF mesh"},
    {"CDF\x01"sv, "a netCDF file (Exodus mesh)"},
});

constexpr auto binary_endings = std::to_array<Name>({
    {".HM", "a HyperMesh model"},
    {".HMBIN", "a HyperMesh model"},
    {".ODB", "an Abaqus result file"},
    {".OP2", "a Nastran result file"},
    {".CATPART", "a CATIA part"},
    {".CATPRODUCT", "a CATIA product"},
    {".PRT", "a CAD part"},
    {".SLDPRT", "a SolidWorks part"},
    {".IPT", "an Inventor part"},
    {".X_B", "a Parasolid part"},
    {".RST", "a restart or result file"},
    {".DB", "a database"},
    {".D3PLOT", "a result file of LS-DYNA"},
    {"D3PLOT", "a result file of LS-DYNA"},
});

/// Beginnings of the first line that is neither blank nor a comment of Radioss, in upper case; "\n" ends the line.
constexpr auto text_beginnings = std::to_array<Name>({
    {"*HEADING", "an Abaqus deck"},
    {"*PREPRINT", "an Abaqus deck"},
    {"BEGIN BULK", "a Nastran deck"},
    {"NASTRAN ", "a Nastran deck"},
    {"INIT MASTER", "a Nastran deck"},
    {"CEND\n", "a Nastran deck"},
    {"SOL ", "a Nastran deck"},
    {"SUBCASE", "a Nastran or OptiStruct deck"},
    {"GRID ", "a Nastran deck"},
    {"GRID,", "a Nastran deck"},
    {"GRID*", "a Nastran deck"},
    {"CQUAD4", "a Nastran deck"},
    {"CTRIA3", "a Nastran deck"},
    {"PSHELL", "a Nastran deck"},
    {"CORD2R", "a Nastran deck"},
    {"INPUTVERSION", "a PAM-CRASH or PAM-STAMP deck"},
    {"ANALYSIS EXPLICIT", "a PAM-CRASH deck"},
    {"SOLVER ", "a PAM-CRASH deck"},
    {"NODE  /", "a PAM-CRASH or PAM-STAMP deck"},
    {"SHELL /", "a PAM-CRASH or PAM-STAMP deck"},
    {"/PREP7", "an ANSYS input file"},
    {"/BATCH", "an ANSYS input file"},
    {"/COM,", "an ANSYS input file"},
    {"/NOPR", "an ANSYS input file"},
    {"NBLOCK", "an ANSYS input file"},
    {"EBLOCK", "an ANSYS input file"},
    {"ET,", "an ANSYS input file"},
    {"SOLID ", "an STL mesh"},
    {"PLY\n", "a PLY mesh"},
    {"OFF\n", "an OFF mesh"},
    {"MTLLIB ", "an OBJ mesh"},
    {"V ", "an OBJ mesh"},
    {"VN ", "an OBJ mesh"},
    {"ISO-10303-21", "a STEP file"},
    {"<?XML", "an XML file"},
    {"<VTKFILE", "a VTK file"},
    {"<!DOCTYPE", "an HTML page"},
    {"<HTML", "an HTML page"},
    {"MESHVERSIONFORMATTED", "a Medit mesh"},
    {"ENSIGHT", "an EnSight file"},
    {"POINT(", "a Gmsh geometry"},
    {"SETFACTORY(", "a Gmsh geometry"},
    {"VARIABLES", "a Tecplot file"},
    {"IMPORT ", "a Python script"},
    {"FROM ", "a Python script"},
    {"DEF ", "a Python script"},
    {"{", "a JSON file"},
    {"[[", "a JSON or TOML file"},
    {"[{", "a JSON file"},
    {"[\"", "a JSON file"},
    {"[]", "a JSON file"},
    {"%YAML", "a YAML file"},
    {"HMASCII", "a HyperMesh ASCII model"},
    {"!", "an input file of ANSYS or another program"},
    {"TITLE =", "a Tecplot file"},
});

/// What only a comment line of Radioss gives away.
constexpr auto comment_beginnings = std::to_array<Name>({
    {"# VTK DATAFILE", "a VTK file"},
    {"$MESHFORMAT", "a Gmsh mesh"},
    {"#VRML", "a VRML scene"},
    {"#!", "a script"},
});

template <std::size_t n>
std::string_view find_beginning(const std::array<Name, n>& table, std::string_view text) {
    const auto found =
        std::find_if(table.begin(), table.end(), [&](const Name& name) { return text.starts_with(name.first); });
    return found == table.end() ? std::string_view{} : found->second;
}

/// 80 bytes of header, the number of triangles, 50 bytes for each.
bool is_binary_stl(std::string_view bytes, std::uintmax_t size) {
    if (bytes.size() < 84) return false;
    std::uint64_t count = 0;
    for (std::size_t i = 4; i-- > 0;)
        count = 256 * count + static_cast<unsigned char>(bytes[80 + i]);
    return size == 84 + 50 * count;
}

/// The next line of the text without blanks at its ends; the text goes on behind it.
std::string_view next_line(std::string_view& text) {
    const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
    const std::string_view line = trimmed(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    return line;
}

/// Keywords that begin with a star belong to LS-DYNA or Abaqus; only the latter parts its options and data by commas.
std::string_view starred(std::string_view line, std::string_view rest) {
    if (line.find(',') != std::string_view::npos) return "an Abaqus deck";
    for (int i = 0; i < 20 && !rest.empty(); ++i) {
        const std::string_view data = next_line(rest);
        if (data.empty() || data.starts_with("$") || data.starts_with("**")) continue;
        const bool commas = data.find(',') != std::string_view::npos;
        if (commas && upper(line) != "*KEYWORD") return "an Abaqus deck";
        break;
    }
    return "an LS-DYNA deck";
}

/// Names and values with commas, semicolons, or an equals sign between them.
std::string_view table_or_settings(std::string_view line, std::string_view rest) {
    const auto letter = [](char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '"' || c == '_'; };
    if (line.front() == '[' && line.back() == ']') return letter(line[1]) ? "a TOML file" : "a JSON file";
    if (!letter(line.front())) return {};
    const std::size_t equals = line.find('=');
    if (equals != std::string_view::npos && trimmed(line.substr(0, equals)).find(' ') == std::string_view::npos)
        return "a TOML file";
    const std::string_view next = next_line(rest);
    for (const char comma : {',', ';'}) {
        const auto fields = std::count(line.begin(), line.end(), comma);
        if (fields > 0 && std::count(next.begin(), next.end(), comma) == fields) return "a CSV table";
    }
    return {};
}

/// "2411" behind the line "-1" that begins a dataset of a universal file.
bool is_dataset_number(std::string_view line) {
    return !line.empty() && line.size() <= 4 && line.find_first_not_of("0123456789") == std::string_view::npos;
}

std::string_view text_format(std::string_view text) {
    for (int lines = 0; lines < 1000 && !text.empty(); ++lines) {
        const std::string_view line = next_line(text);
        if (line.empty()) continue;
        const std::string head = upper(line.substr(0, 40)) + "\n";
        if (line.front() == '#' || line.front() == '$') {
            if (const auto name = find_beginning(comment_beginnings, head); !name.empty()) return name;
            continue;
        }
        if (line.starts_with("**")) continue;  // a comment of Abaqus
        if (const auto name = find_beginning(text_beginnings, head); !name.empty()) return name;
        if (line.front() == '*') return starred(line, text);
        if (line == "-1") return is_dataset_number(next_line(text)) ? "an I-DEAS universal file" : "";
        if (line.front() == '/') return {};
        return table_or_settings(line, text);
    }
    return {};
}

}  // namespace

std::string foreign_format(std::string_view bytes, std::string_view path, std::uintmax_t size) {
    if (const auto name = find_beginning(binary_beginnings, bytes); !name.empty()) return std::string(name);
    if (is_binary_stl(bytes, size)) return "a binary STL mesh";
    const bool text = bytes.substr(0, 4096).find('\0') == std::string_view::npos;
    if (text) {
        if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
        return std::string(text_format(bytes));
    }
    const std::string name = upper(path);
    const auto ending = std::find_if(binary_endings.begin(), binary_endings.end(),
                                     [&](const Name& known) { return name.ends_with(known.first); });
    return ending == binary_endings.end() ? "" : std::string(ending->second);
}

}  // namespace type21
