#include "verification/results/t01/t01_columns.h"

#include <array>

namespace type21 {

std::string_view interface_variable(int code) {
    constexpr std::array<std::string_view, 29> names{
        "FNX",    "FNY",  "FNZ",  "FTX",  "FTY",   "FTZ",      "",        "|FNX|",   "|FNY|", "|FNZ|",
        "||FN||", "|FX|", "|FY|", "|FZ|", "||F||", "",         "",        "",        "",      "",
        "",       "",     "",     "",     "QFRIC", "CE_ELAST", "CE_FRIC", "CE_DAMP", ""};
    return code < 1 || code > static_cast<int>(names.size()) ? "" : names[static_cast<size_t>(code - 1)];
}

std::string_view node_variable(int code) {
    constexpr std::array<std::string_view, 12> names{"DX", "DY", "DZ", "VX",  "VY",  "VZ",
                                                     "AX", "AY", "AZ", "VRX", "VRY", "VRZ"};
    constexpr std::array<std::string_view, 3> reactions{"REACX", "REACY", "REACZ"};
    if (code >= 1 && code <= static_cast<int>(names.size())) return names[static_cast<size_t>(code - 1)];
    if (code >= 620 && code <= 622) return reactions[static_cast<size_t>(code - 620)];
    return "";
}

}  // namespace type21
