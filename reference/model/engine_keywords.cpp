#include "reference/model/engine_keywords.h"

#include <algorithm>
#include <array>

namespace type21 {

namespace {

/// The order of sums (/PARITH) is fixed here anyway.
constexpr auto harmless = std::to_array<std::string_view>({
    "VERS",
    "PRINT",
    "PARITH",
    "MON",
    "RFILE",
    "TITLE",
    "PROC",
    "REPORT",
    "DEBUG",
    "MEMORY",
    "SPMD",
    "CHKPT",
    "CHECKSUM",
    "RUNNAME",
});

constexpr auto output = std::to_array<std::string_view>({
    "ANIM",   "H3D",    "OUTP",   "STATE",  "TH",     "DYNAIN", "ABF",    "SENSOR", "GAUGE",  "NOISE",
    "PATRAN", "ATH",    "BTH",    "CTH",    "DTH",    "ETH",    "FTH",    "GTH",    "HTH",    "ITH",
    "ATFILE", "BTFILE", "CTFILE", "DTFILE", "ETFILE", "FTFILE", "GTFILE", "HTFILE", "ITFILE", "SECT",
});

}  // namespace

EngineKeyword engine_keyword(std::string_view word) {
    if (std::find(harmless.begin(), harmless.end(), word) != harmless.end()) return EngineKeyword::harmless;
    if (std::find(output.begin(), output.end(), word) != output.end()) return EngineKeyword::output;
    return EngineKeyword::unsupported;
}

}  // namespace type21
