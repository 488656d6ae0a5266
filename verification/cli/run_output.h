/// @file The summary that `type21 run` prints.
#pragma once

#include <string>

#include "verification/results/record/run_summary.h"

namespace type21::cli {

/// Cycles, contact in numbers, final impulses, energies and balance of each interface, with units.
std::string run_text(const RunSummary& summary, const HostScene& scene, const std::string& folder);

}  // namespace type21::cli
