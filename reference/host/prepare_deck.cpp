/// @file Reads, resolves and plans a deck; checks whether it can be run.
#include "reference/host/prepare_deck.h"

#include <memory>
#include <utility>

#include <fmt/format.h>

#include "reference/deck/deck.h"
#include "reference/host/conditions.h"
#include "reference/host/warnings/warnings.h"
#include "reference/model/as_built_option.h"
#include "reference/model/resolve.h"

namespace type21 {
namespace {

/// NAME_0001.rad of NAME_0000.rad.
std::string engine_path(const std::string& starter) {
    const std::string ending = "_0000.rad";
    if (!starter.ends_with(ending)) return "NAME_0001.rad (the starter deck is NAME_0000.rad)";
    return starter.substr(0, starter.size() - ending.size()) + "_0001.rad";
}

}  // namespace

PreparedDeck prepare_deck(const std::string& path, const std::string& as_built, bool needs_engine,
                          const std::string& thickness) {
    PreparedDeck prepared;
    Problems& problems = prepared.problems;
    const AsBuilt departures = parse_as_built(as_built, problems);
    Deck deck = read_deck(path, problems);
    prepared.files = deck.files;
    if (!thickness.empty()) prepared.files.push_back(thickness);
    const bool readable = !(deck.starter.empty() && problems.has_errors());
    if (readable && needs_engine && !deck.has_engine)
        problems.add({Severity::error,
                      {path, 0},
                      "",
                      "",
                      "",
                      "a run needs the engine deck beside the starter deck",
                      fmt::format("Write {} with at least /RUN and the end time", engine_path(path))});
    // Even a faulty deck is resolved, so that its author sees all problems in one go.
    if (!readable) return prepared;
    auto model = std::make_shared<const Model>(resolve_and_forget(deck, departures, problems));
    check_interfaces(deck, *model, problems);
    if (problems.has_errors()) return prepared;
    warn_of_surprises(deck, *model, problems);
    HostScene scene = plan(std::move(model));
    check_runnable(scene, problems, needs_engine);
    if (!thickness.empty()) prepared.thickness = ThicknessHistory::read(thickness, *scene.host, problems);
    if (!problems.has_errors()) prepared.scene = std::move(scene);
    return prepared;
}

}  // namespace type21
