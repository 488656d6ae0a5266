#include "reference/deck/printable.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/deck/utf8.h"

namespace type21 {

namespace {

bool steers(char32_t code) {
    return code < 0x20 || (code >= 0x7F && code < 0xA0) || code == 0x200E || code == 0x200F || code == 0x2028 ||
           code == 0x2029 || (code >= 0x202A && code <= 0x202E) || (code >= 0x2066 && code <= 0x2069);
}

std::string written_out(const Utf8Character& character, unsigned char byte) {
    if (!character.valid || character.code < 0x100) {
        if (character.code == '\n') return "\\n";
        if (character.code == '\r') return "\\r";
        if (character.code == '\t') return "\\t";
        return fmt::format("\\x{:02x}", character.valid ? static_cast<unsigned>(character.code) : byte);
    }
    return fmt::format("\\u{:04x}", static_cast<unsigned>(character.code));
}

}  // namespace

std::string printable(std::string_view text) {
    const bool plain = std::all_of(text.begin(), text.end(), [](char c) { return c >= 0x20 && c < 0x7F; });
    if (plain) return std::string(text);
    std::string out;
    while (!text.empty()) {
        const Utf8Character character = first_character(text);
        if (character.valid && !steers(character.code)) {
            out += text.substr(0, character.bytes);
        } else {
            out += written_out(character, static_cast<unsigned char>(text[0]));
        }
        text.remove_prefix(character.bytes);
    }
    return out;
}

std::string printable(std::string_view text, std::size_t most) {
    if (text.size() <= most) return printable(text);
    std::size_t end = most;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U)
        --end;  // never through a character
    return fmt::format("{} ... ({} characters)", printable(text.substr(0, end)), text.size());
}

}  // namespace type21
