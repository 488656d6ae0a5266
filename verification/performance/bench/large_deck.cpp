/// @file Writes the deck that is read in measure_reading().
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "verification/performance/bench/reading.h"

namespace type21::bench {

namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

File open(const std::string& path) {
    File file(std::fopen(path.c_str(), "wb"));
    if (!file) throw std::runtime_error("bench: cannot write " + path);
    return file;
}

constexpr double size = 2.0;  ///< edge of a shell [mm]

/// Nodes of a grid of `side` times `side` from id `first` on, at height z.
void write_nodes(std::FILE* file, int first, int side, double z) {
    fmt::print(file, "/NODE\n");
    for (int row = 0; row < side; ++row)
        for (int column = 0; column < side; ++column)
            fmt::print(file, "{:>10}{:>20.10f}{:>20.10f}{:>20.10f}\n", first + row * side + column, size * column,
                       size * row, z);
}

/// Those shells of the grid that lie in its corner of `corner` times `corner`, or those that do not.
void write_shells(std::FILE* file, int first, int side, int part, int corner, bool in_corner) {
    fmt::print(file, "/SHELL/{}\n", part);
    for (int row = 0; row + 1 < side; ++row) {
        for (int column = 0; column + 1 < side; ++column) {
            if ((row < corner && column < corner) != in_corner) continue;
            const int a = first + row * side + column;
            fmt::print(file, "{:>10}{:>10}{:>10}{:>10}{:>10}\n", a, a, a + 1, a + side + 1, a + side);
        }
    }
}

void write_cards(std::FILE* file) {
    fmt::print(file,
               "#RADIOSS STARTER\n/BEGIN\nlarge\n{:>10}{:>10}\n{:>20}{:>20}{:>20}\n{:>20}{:>20}{:>20}\n/TITLE\n"
               "a large deck\n",
               2025, 0, "Mg", "mm", "s", "Mg", "mm", "s");
    fmt::print(file, "/MAT/ELAST/1\nsheet\n{:>20}\n{:>20}{:>20}\n/MAT/VOID/2\ntool\n{:>20}{:>20}{:>20}\n", "7.8e-09",
               "210000.0", "0.3", "7.8e-09", "210000.0", "0.3");
    fmt::print(file, "/PROP/SHELL/1\nsheet\n\n\n{:>10}{:>10}{:>20}\n/PROP/VOID/2\ntool\n{:>20}\n", 5, "", "1.0", "1.0");
    fmt::print(file, "/PART/1\nblank\n{:>10}{:>10}\n/PART/2\nblank\n{:>10}{:>10}\n", 1, 1, 1, 1);
    fmt::print(file, "/PART/3\ntool\n{:>10}{:>10}\n", 2, 2);
}

void write_contact(std::FILE* file, int main_node) {
    fmt::print(file, "/NODE\n{:>10}{:>20}{:>20}{:>20}\n", main_node, 0.0, 0.0, -10.0);
    fmt::print(file, "/SURF/PART/1\nblank\n{:>10}\n/SURF/PART/2\ntool\n{:>10}\n", 1, 3);
    fmt::print(file, "/GRNOD/PART/1\nblank\n{:>10}{:>10}\n/GRNOD/PART/2\ntool\n{:>10}\n", 1, 2, 3);
    fmt::print(file, "/GRNOD/NODE/3\nmain node\n{:>10}\n", main_node);
    fmt::print(file, "/RBODY/1\ntool\n{:>10}{:>10}{:>10}{:>10}{:>20}{:>10}{:>10}{:>10}\n{:>20}{:>20}{:>20}\n\n\n",
               main_node, 0, 0, 0, "0.01", 2, 0, 4, "100.0", "100.0", "100.0");
    fmt::print(file, "/BCS/1\nblank\n   111 111{:>10}{:>10}\n/BCS/2\nguide\n   110 111{:>10}{:>10}\n", 0, 1, 0, 3);
    fmt::print(file, "/FUNCT/1\none\n{:>20}{:>20}\n{:>20}{:>20}\n", "0.0", "1.0", "1.0", "1.0");
    fmt::print(file, "/IMPVEL/1\nup\n{:>10}{:>10}{:>10}{:>10}{:>10}\n{:>20}{:>20}\n", 1, "Z", 0, 0, 3, "1.0", "1000.0");
    fmt::print(file, "/INTER/TYPE21/1\ncontact\n{:>10}{:>10}\n\n\n{:>40}{:>20}\n\n\n\n\n\n\n\n{:>10}\n/END\n", 1, 2,
               "0.1", "0.5", 1);
}

}  // namespace

std::string write_large_deck(const std::string& folder, int nodes) {
    const int side = std::max(3, static_cast<int>(std::sqrt(static_cast<double>(nodes))));
    const int corner = std::min(side - 1, 50);
    const std::string path = folder + "/large_0000.rad";
    const File starter = open(path);
    write_cards(starter.get());
    write_nodes(starter.get(), 1, side, 0.0);
    write_shells(starter.get(), 1, side, 1, corner, true);
    write_shells(starter.get(), 1, side, 2, corner, false);
    const int tool_side = corner + 1;
    const int first = side * side + 1;
    write_nodes(starter.get(), first, tool_side, -2.0);
    write_shells(starter.get(), first, tool_side, 3, corner, true);
    write_contact(starter.get(), first + tool_side * tool_side);
    fmt::print(open(folder + "/large_0001.rad").get(), "/RUN/large/1\n{:>20}\n/DTIX\n{:>20}{:>20}\n", "1e-4", "1e-6",
               "1e-6");
    return path;
}

}  // namespace type21::bench
