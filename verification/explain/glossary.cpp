#include "verification/explain/glossary.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <optional>

#include <fmt/format.h>

#include "verification/explain/glossary_text.h"

namespace type21 {
namespace {

constexpr size_t text_width = 96;
constexpr size_t label_width = 10;

/// Lower case; a space, a hyphen and an underscore are the same.
std::string plain(std::string_view word) {
    std::string out;
    for (const unsigned char c : word)
        out += c == '-' || c == '_' ? ' ' : static_cast<char>(std::tolower(c));
    return out;
}

/// "a, b" -> {"a", "b"}
std::vector<std::string> parts(std::string_view text, std::string_view separator) {
    std::vector<std::string> out;
    for (size_t begin = 0; begin <= text.size();) {
        const size_t end = std::min(text.find(separator, begin), text.size());
        if (end > begin) out.emplace_back(text.substr(begin, end - begin));
        begin = end + separator.size();
    }
    return out;
}

/// What follows a label such as "Also: " at the start of a paragraph.
std::optional<std::string_view> after(std::string_view paragraph, std::string_view label) {
    if (!paragraph.starts_with(label)) return std::nullopt;
    return paragraph.substr(label.size());
}

void add_paragraph(std::string_view paragraph, GlossaryEntry& entry) {
    if (const auto symbol = after(paragraph, "Symbol: ")) {
        const size_t unit = std::min(symbol->find(". Unit: "), symbol->size());
        entry.symbols = parts(symbol->substr(0, unit), ", ");
        if (unit < symbol->size()) entry.unit = symbol->substr(unit + 8);
    } else if (const auto also = after(paragraph, "Also: ")) {
        entry.also = parts(*also, ", ");
    } else if (const auto formula = after(paragraph, "Formula: ")) {
        entry.formula = *formula;
        std::erase(entry.formula, '`');
    } else if (const auto see = after(paragraph, "See: ")) {
        entry.places = parts(*see, "; ");
    } else if (const auto picture = after(paragraph, "Picture: ")) {
        entry.picture = *picture;
    } else {
        entry.meaning += (entry.meaning.empty() ? "" : " ") + std::string(paragraph);
        std::erase(entry.meaning, '`');
    }
}

/// reference/formulation/03_projection.md for "Formulation 3, step 6"; empty without such a chapter.
std::string file_of(std::string_view place) {
    int chapter = 0;
    for (const char c : place.substr(place.find(' ') + 1)) {
        if (c < '0' || c > '9') break;
        chapter = 10 * chapter + (c - '0');
    }
    for (const std::string& file : parts(chapter_files(), " "))
        if (file.starts_with(fmt::format("{:02}_", chapter))) return "reference/formulation/" + file;
    return {};
}

/// Letters to put in, take out or change, to make one word of the other.
size_t letters_apart(std::string_view one, std::string_view other) {
    std::vector<size_t> row(other.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 1; i <= one.size(); ++i) {
        size_t diagonal = row[0];
        row[0] = i;
        for (size_t j = 1; j <= other.size(); ++j) {
            const size_t changed = diagonal + (one[i - 1] == other[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({row[j] + 1, row[j - 1] + 1, changed});
        }
    }
    return row.back();
}

std::string line(std::string_view label, std::string_view text) {
    std::string out;
    for (bool first = true; first || !text.empty(); first = false) {
        size_t end = text.size();
        if (end > text_width) end = std::min(text.rfind(' ', text_width), text.size());
        out += fmt::format("{:<{}}  {}\n", first ? label : "", label_width, text.substr(0, end));
        text.remove_prefix(std::min(end + 1, text.size()));
    }
    return out;
}

}  // namespace

std::vector<GlossaryEntry> read_glossary(std::string_view markdown) {
    std::vector<GlossaryEntry> entries;
    std::string paragraph;
    const auto end_paragraph = [&] {
        if (!paragraph.empty() && !entries.empty()) add_paragraph(paragraph, entries.back());
        paragraph.clear();
    };
    for (size_t begin = 0; begin < markdown.size();) {
        const size_t end = std::min(markdown.find('\n', begin), markdown.size());
        const std::string_view text = markdown.substr(begin, end - begin);
        begin = end + 1;
        if (const auto term = after(text, "## ")) {
            end_paragraph();
            entries.emplace_back().term = *term;
        } else if (text.empty()) {
            end_paragraph();
        } else {
            paragraph += (paragraph.empty() ? "" : " ") + std::string(text);
        }
    }
    end_paragraph();
    return entries;
}

const std::vector<GlossaryEntry>& glossary() {
    static const std::vector<GlossaryEntry> entries = read_glossary(glossary_markdown());
    return entries;
}

const GlossaryEntry* find_term(std::string_view word) {
    const std::string wanted = plain(word);
    const auto holds = [&](const std::vector<std::string>& words) {
        return std::any_of(words.begin(), words.end(), [&](const std::string& one) { return plain(one) == wanted; });
    };
    const auto first = [](const auto& matches) -> const GlossaryEntry* {
        const auto found = std::find_if(glossary().begin(), glossary().end(), matches);
        return found == glossary().end() ? nullptr : &*found;
    };
    if (wanted.empty()) return nullptr;
    if (const auto* entry = first([&](const GlossaryEntry& e) { return plain(e.term) == wanted; })) return entry;
    if (const auto* entry = first([&](const GlossaryEntry& e) { return holds(e.also); })) return entry;
    if (const auto* entry = first([&](const GlossaryEntry& e) {
            return std::find(e.symbols.begin(), e.symbols.end(), word) != e.symbols.end();
        }))
        return entry;
    return first([&](const GlossaryEntry& e) { return holds(e.symbols); });
}

std::vector<std::string> near_terms(std::string_view word) {
    const std::string wanted = plain(word);
    const size_t limit = std::max<size_t>(1, wanted.size() / 3);
    std::vector<std::pair<size_t, std::string>> near;
    for (const GlossaryEntry& entry : glossary()) {
        size_t least = letters_apart(wanted, plain(entry.term));
        for (const std::string& also : entry.also)
            least = std::min(least, letters_apart(wanted, plain(also)));
        if (least <= limit) near.emplace_back(least, entry.term);
    }
    std::stable_sort(near.begin(), near.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    std::vector<std::string> out;
    for (size_t i = 0; i < std::min<size_t>(near.size(), 3); ++i)
        out.push_back(near[i].second);
    return out;
}

std::string term_text(const GlossaryEntry& entry) {
    const bool fits = entry.term.size() <= label_width;
    std::string out = fits ? "" : entry.term + "\n";
    out += line(fits ? entry.term : "", entry.meaning);
    if (!entry.symbols.empty()) out += line("symbol", fmt::format("{} {}", fmt::join(entry.symbols, ", "), entry.unit));
    if (!entry.also.empty()) out += line("also", fmt::format("{}", fmt::join(entry.also, ", ")));
    if (!entry.formula.empty()) out += line("formula", entry.formula);
    for (size_t i = 0; i < entry.places.size(); ++i)
        out += line(i == 0 ? "see" : "", fmt::format("{} ({})", entry.places[i], file_of(entry.places[i])));
    if (!entry.picture.empty()) out += line("picture", "reference/formulation/" + entry.picture);
    return out;
}

}  // namespace type21
