/// @file The keyword of an imposed motion, for messages.
#pragma once

#include <string_view>

#include "reference/model/motion_conditions.h"

namespace type21 {

/// "IMPVEL", "IMPDISP" or "IMPACC".
inline std::string_view keyword_of(ImposedMotion::Kind kind) {
    switch (kind) {
        case ImposedMotion::Kind::velocity:
            return "IMPVEL";
        case ImposedMotion::Kind::displacement:
            return "IMPDISP";
        case ImposedMotion::Kind::acceleration:
            return "IMPACC";
    }
    return "";
}

}  // namespace type21
