/// @file The glossary of the formulation: reference/formulation/glossary.md, which is built into the program.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace type21 {

/// One entry, as the text has it. What an entry does not have is empty.
struct GlossaryEntry {
    std::string term;
    std::vector<std::string> symbols;
    std::string unit;               ///< "[length]"
    std::vector<std::string> also;  ///< other words for it
    std::string meaning;
    std::string formula;
    std::vector<std::string> places;  ///< "Formulation 3, step 6"
    std::string picture;              ///< relative to reference/formulation
};

/// The entries of a text in the form of glossary.md, in its order.
std::vector<GlossaryEntry> read_glossary(std::string_view markdown);

/// The entries that are built in.
const std::vector<GlossaryEntry>& glossary();

/// The entry of a term, another word for it or its symbol, in any case; nullptr if there is none. A term comes before
/// another word, and a symbol in its own case before one in any case.
const GlossaryEntry* find_term(std::string_view word);

/// The built-in terms and other words that differ from `word` in few letters, the nearest first, at most three.
std::vector<std::string> near_terms(std::string_view word);

/// The entry for a reader: meaning, symbol, formula, and where the formulation has it.
std::string term_text(const GlossaryEntry& entry);

}  // namespace type21
