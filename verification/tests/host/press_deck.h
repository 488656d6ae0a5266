/// @file The text of a small press whose tool and cards can be spoilt one at a time.
#pragma once

#include <string>
#include <vector>

#include "verification/tests/deck/problem_search.h"

namespace type21::test {

/// A blank of 2 x 2 quads of 10 mm (nodes 1 to 9, part 1, 1 mm, fixed) at z = 0 under a tool of 3 x 3 quads of 12 mm
/// (nodes 101 to 116 row by row along x, part 2, void) at z = 2 that looks down and is driven down by 1000 mm/s for
/// 1 ms through its main node 201. Mg mm s, version 2025. Nothing of it calls for a warning.
struct PressDeck {
    double tool_edge = 12;
    double origin = 0;                    ///< added to every coordinate [mm]
    std::vector<int> turned;              ///< ranks of tool shells, from 0, that run the other way
    bool unmerged = false;                ///< the third column of tool shells has nodes of its own: 301 to 304
    std::string more_nodes, more_shells;  ///< lines for /NODE, and for the tool's /SHELL
    std::string density = "7.8e-09", thickness = "1.0", fric = "0.0", igap = "0", gapmin = "0.5", depth = "0.0";
    std::string times;  ///< Tstart and Tstop of the interface
    std::string blank_material =
        "/MAT/ELAST/1\nsheet\n             7.8e-09\n            210000.0                 0.3\n";
    std::string function = "                 0.0                 1.0\n               1e-03                 1.0\n";
    std::string drive = "/IMPVEL/1\n";  ///< the keyword; the scale factor is -1000
    std::string cards;                  ///< before /END
    std::string step = "1e-6";

    std::string starter() const;
    std::string engine() const;
};

/// The warnings of the deck; the test fails where it has errors.
Problems warnings_of(const PressDeck& press);

}  // namespace type21::test
