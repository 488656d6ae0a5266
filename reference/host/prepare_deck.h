/// @file From the path of a deck to a scene that runs, or to everything that is wrong with it.
#pragma once

#include <optional>
#include <string>

#include "reference/deck/problem.h"
#include "reference/host/march.h"
#include "reference/host/thickness_history.h"

namespace type21 {

/// A scene, or the problems that there is none for. Warnings are in problems either way.
struct PreparedDeck {
    Problems problems;
    std::optional<HostScene> scene;
    std::optional<ThicknessHistory> thickness;  ///< of --thickness
    std::vector<std::string> files;             ///< every file that was read: decks, what they include, thickness

    /// For march(); points into this.
    MarchOptions options() const {
        MarchOptions options;
        options.thickness = thickness ? &*thickness : nullptr;
        return options;
    }
};

/// Reads, resolves and checks a deck; throws nothing of its own.
/// @param path          of the starter deck; the engine deck is looked for beside it
/// @param as_built      departures to switch on, as --as-built takes them: "", "all", "D03,D24"
/// @param needs_engine  true when the scene is to be run: a missing engine deck is then an error. Whatever else a run
///                      would refuse is an error either way.
/// @param thickness     CSV of the shells' thickness over time, empty: none
/// @return the scene, or errors in problems
PreparedDeck prepare_deck(const std::string& path, const std::string& as_built, bool needs_engine,
                          const std::string& thickness = {});

}  // namespace type21
