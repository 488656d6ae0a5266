/// @file What becomes of the keywords of the engine deck that this program does not compute with.
#pragma once

#include <string_view>

namespace type21 {

enum class EngineKeyword {
    harmless,    ///< neither physics nor results: listings, restarts, processors, the order of sums
    output,      ///< steers output that is not written: one warning for all
    unsupported  ///< may change the physics: an error
};

/// By the first word of the keyword.
EngineKeyword engine_keyword(std::string_view word);

}  // namespace type21
