#include "press_deck.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/deck/deck.h"
#include "reference/host/warnings/warnings.h"
#include "reference/model/resolve.h"

namespace type21::test {
namespace {

std::string node(int id, double x, double y, double z) {
    return fmt::format("{:>10}{:>20}{:>20}{:>20}\n", id, x, y, z);
}

std::string nodes_of(const PressDeck& press) {
    std::string text;
    const double o = press.origin;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            text += node(1 + 3 * row + column, o + 10 * column, o + 10 * row, o);
    const double start = 10 - 1.5 * press.tool_edge;
    const auto tool_node = [&](int id, int row, int column) {
        text += node(id, o + start + press.tool_edge * column, o + start + press.tool_edge * row, o + 2);
    };
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            tool_node(101 + 4 * row + column, row, column);
    if (press.unmerged)
        for (int row = 0; row < 4; ++row)
            tool_node(301 + row, row, 2);
    return text + node(201, o + 10, o + 10, o + 20) + press.more_nodes;
}

std::string blank_shells() {
    std::string text;
    for (int row = 0; row < 2; ++row)
        for (int column = 0; column < 2; ++column) {
            const int first = 1 + 3 * row + column;
            text += fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}\n", 1 + 2 * row + column, first, first + 1, first + 4,
                                first + 3);
        }
    return text;
}

std::string tool_shells(const PressDeck& press) {
    std::string text;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) {
            const int rank = 3 * row + column;
            const bool own = press.unmerged && column == 2;
            const int first = own ? 301 + row : 101 + 4 * row + column;
            const int last = own ? 302 + row : 105 + 4 * row + column;
            const int right = 102 + 4 * row + column;
            int second = last;
            int fourth = right;
            if (std::count(press.turned.begin(), press.turned.end(), rank) != 0) std::swap(second, fourth);
            text += fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}\n", 101 + rank, first, second, right + 4, fourth);
        }
    return text + press.more_shells;
}

}  // namespace

std::string PressDeck::starter() const {
    return "#RADIOSS STARTER\n/BEGIN\npress\n      2025         0\n                  Mg                  mm            "
           "  "
           "     s\n                  Mg                  mm                   s\n" +
           blank_material + "/MAT/VOID/2\ntool\n" + fmt::format("{:>20}{:>20}{:>20}\n", density, 210000.0, 0.3) +
           "/PROP/SHELL/1\nsheet\n\n\n" + fmt::format("{:>10}{:>10}{:>20}\n", 5, "", thickness) +
           "/PROP/VOID/2\ntool\n                 1.0\n/PART/1\nsheet\n         1         1\n/PART/2\ntool\n         2  "
           "  "
           "     2\n/NODE\n" +
           nodes_of(*this) + "/SHELL/1\n" + blank_shells() + "/SHELL/2\n" + tool_shells(*this) +
           "/SURF/PART/1\nblank\n         1\n/SURF/PART/2\ntool\n         2\n/GRNOD/PART/1\nblank\n         1\n" +
           "/GRNOD/PART/2\ntool\n         2\n/GRNOD/NODE/3\nmain node\n       201\n/RBODY/7\ntool\n       201         "
           "0         0         0              "
           "  0.02         2         0         4\n              1000.0              1000.0              1000.0\n       "
           "  "
           "        0.0                 0.0                 0.0\n\n/BCS/1\nguide\n   110 111         0         "
           "3\n/BCS/2\n"
           "blank\n   111 111         0         1\n/FUNCT/1\nstroke\n" +
           function + drive + "down\n         1         Z         0         0         3         0         0\n" +
           fmt::format("{:>20}{:>20}\n", 1.0, -1000.0) + "/INTER/TYPE21/1\ncontact\n" +
           fmt::format("{:>10}{:>10}{:>10}{:>10}{:>10}\n", 1, 2, "", "", igap) +
           fmt::format("{:>20}{:>20}{:>20}\n", "", "", depth) + "\n" +
           fmt::format("{:>20}{:>20}{:>20}{}\n", "", fric, gapmin, times) + std::string(7, '\n') + "         7\n" +
           cards + "/END\n";
}

std::string PressDeck::engine() const {
    return "#RADIOSS ENGINE\n/VERS/2025\n/RUN/press/1\n  0.001\n/DTIX\n" + step + " " + step + "\n";
}

Problems warnings_of(const PressDeck& press) {
    Problems problems;
    const Deck deck = read_deck({{"press_0000.rad", press.starter()}, {"press_0001.rad", press.engine()}}, problems);
    const Model model = resolve(deck, AsBuilt{}, problems);
    EXPECT_FALSE(problems.has_errors()) << all_of(problems);
    Problems warnings;
    if (!problems.has_errors()) warn_of_surprises(deck, model, warnings);
    return warnings;
}

}  // namespace type21::test
