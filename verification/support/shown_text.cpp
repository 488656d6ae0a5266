#include "verification/support/shown_text.h"

#include <fmt/format.h>

#include "reference/deck/utf8.h"

namespace type21 {
std::string shown(std::string_view text, size_t limit) {
    std::string out;
    for (size_t count = 0; !text.empty(); ++count) {
        if (count == limit) return out + "...";
        const Utf8Character character = first_character(text);
        const std::string_view bytes = text.substr(0, character.bytes);
        const bool control = character.code < 0x20 || (character.code >= 0x7F && character.code < 0xA0);
        if (!character.valid || control) {
            for (const char c : bytes)
                out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        } else {
            out += bytes;
        }
        text.remove_prefix(character.bytes);
    }
    return out;
}

}  // namespace type21
