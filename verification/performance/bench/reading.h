/// @file How fast a deck is read, and in how much memory.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "verification/performance/bench/targets.h"

namespace type21::bench {

/// A deck that was read once: from the file to the scene, as `type21 check` does.
struct ReadingRow {
    std::size_t nodes = 0, shells = 0;
    std::size_t bytes = 0;           ///< of the deck
    double seconds = 0;              ///< processor time of one core
    double peak_bytes_per_node = 0;  ///< largest resident memory of the process, per node
    double rate() const { return seconds > 0 ? static_cast<double>(bytes) / seconds / 1e6 : 0; }  ///< [MB/s]
};

/// The deck large_0000.rad and its engine deck: a fixed blank of about `nodes` nodes and as many shells. A corner of at
/// most 2500 shells is in contact with a driven tool, so that what is measured is reading.
/// @return the path of the starter deck
std::string write_large_deck(const std::string& folder, int nodes);

/// Writes such a deck into a temporary folder and reads it in a process of its own, so that the memory is that of
/// reading alone.
/// @throws std::runtime_error when the folder or the process cannot be made, or the deck is refused
ReadingRow measure_reading(int nodes);

std::string to_text(const std::vector<ReadingRow>& rows);
nlohmann::ordered_json to_json(const std::vector<ReadingRow>& rows);

/// 100 MB/s per core and below 300 bytes a node.
std::vector<Target> reading_targets(const ReadingRow& row);

}  // namespace type21::bench
