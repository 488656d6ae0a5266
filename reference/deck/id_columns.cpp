#include "reference/deck/id_columns.h"

#include <algorithm>
#include <map>
#include <string>

#include "reference/deck/text_file.h"

namespace type21 {

namespace {

/// One id field of line 1, or one of every line behind the title.
struct Column {
    int first;
    IdKind kind;
};

using Columns = std::vector<Column>;
constexpr IdKind other = IdKind::other;

/// Cards whose ids stand in line 1 alone. A card of no entry, such as /MAT, has none but that of its keyword.
const std::map<std::string, Columns, std::less<>>& fixed_cards() {
    static const std::map<std::string, Columns, std::less<>> table{
        {"PART", {{1, IdKind::property}, {11, IdKind::material}, {21, other}}},
        {"RBODY", {{1, IdKind::node}, {11, other}, {21, other}, {61, other}, {91, other}}},
        {"BCS", {{11, other}, {21, other}}},
        {"IMPVEL", {{1, other}, {21, other}, {31, other}, {41, other}, {51, other}}},
        {"IMPDISP", {{1, other}, {21, other}, {31, other}, {41, other}, {51, other}}},
        {"INIVEL/TRA", {{61, other}, {71, other}}},
        {"CLOAD", {{1, other}, {21, other}, {31, other}, {41, other}}},
        {"ADMAS", {{21, other}}},
        {"IMPTEMP", {{1, other}, {11, other}, {21, other}}},
        {"INITEMP", {{21, other}}},
        {"TRANSFORM/TRA", {{1, other}, {71, IdKind::node}, {81, IdKind::node}}},
        {"TRANSFORM/ROT", {{1, other}, {71, IdKind::node}, {81, IdKind::node}}},
        {"TRANSFORM/SYM", {{1, other}, {71, IdKind::node}, {81, IdKind::node}}},
        {"TRANSFORM/SCA", {{1, other}, {71, IdKind::node}}},
        {"TRANSFORM/MATRIX", {{1, other}}},
        {"BOX/RECTA", {{1, IdKind::node}, {11, IdKind::node}, {21, other}}},
        {"BOX/CYLIN", {{1, IdKind::node}, {11, IdKind::node}}},
        {"BOX/SPHER", {{1, IdKind::node}}},
        {"MAT", {}},
        {"HEAT", {}},
        {"PROP", {}},
        {"FUNCT", {}},
        {"SENSOR/TIME", {}},
        {"SKEW/FIX", {}},
        {"FRAME/FIX", {}},
        {"TITLE", {}},
    };
    return table;
}

/// What a list card lists: by the word behind its family.
IdKind listed(std::string_view word) {
    if (word == "NODE" || word == "NODENS") return IdKind::node;
    if (word == "SHEL" || word == "SHELL" || word == "SH3N" || word == "ELEM") return IdKind::element;
    if (word == "PART") return IdKind::part;
    if (word == "MAT") return IdKind::material;
    if (word == "PROP") return IdKind::property;
    return IdKind::other;
}

bool is_list(const Card& card) {
    const std::string& word = card.words[0];
    return word == "GRNOD" || word == "GRSHEL" || word == "GRSH3N" || word == "GRPART" || word == "SURF" ||
           word == "SUBSET" || (word == "BOX" && card.words.size() > 1 && card.words[1] == "BOX") || word == "TH";
}

void append_lists(const Card& card, std::vector<IdField>& fields) {
    const std::string type = card.words.size() > 1 ? card.words[1] : "";
    if (type == "SUBMODEL") return;  // submodels keep their ids
    const bool ranges = type == "GENE" || type == "GEN_INCR";
    const IdKind member = card.words[0] == "GRNOD"    ? IdKind::node
                          : card.words[0] == "GRPART" ? IdKind::part
                                                      : IdKind::element;
    for (std::size_t line = 1; line < card.lines.size(); ++line) {
        if (type == "SEG") {
            for (int first = 11; first <= 41; first += 10)
                fields.push_back({line, first, IdKind::node});
            continue;
        }
        const int last = type == "GEN_INCR" ? 81 : 91;
        for (int first = 1; first <= last; first += 10) {
            if (type == "GEN_INCR" && first % 30 == 21) continue;  // the step
            fields.push_back({line, first, ranges ? member : listed(type)});
        }
    }
}

/// The id lines of a /TH card: those that begin with a number. /TH/NODE has one id a line.
void append_history(const Card& card, std::vector<IdField>& fields) {
    const bool nodes = card.words.size() > 1 && card.words[1] == "NODE";
    for (std::size_t line = 1; line < card.lines.size(); ++line) {
        const std::string_view word = trimmed(card.lines[line].text().substr(0, 10));
        if (word.empty() || word.find_first_not_of("0123456789") != std::string_view::npos) continue;
        for (int first = 1; first <= (nodes ? 1 : 91); first += 10)
            fields.push_back({line, first, nodes ? IdKind::node : IdKind::other});
    }
}

}  // namespace

bool has_id(const Card& card) {
    return card.words[0] != "NODE" && card.words[0] != "TITLE";
}

IdKind kind_of_keyword(const Card& card) {
    const std::string& word = card.words[0];
    if (word == "PART" || word == "SHELL" || word == "SH3N") return IdKind::part;
    if (word == "MAT" || word == "HEAT") return IdKind::material;
    return word == "PROP" ? IdKind::property : IdKind::other;
}

bool id_fields(const Card& card, std::vector<IdField>& fields) {
    const std::string& word = card.words[0];
    if (word == "NODE" || word == "SHELL" || word == "SH3N") {
        const int corners = word == "NODE" ? 0 : word == "SHELL" ? 4 : 3;
        for (std::size_t line = 0; line < card.lines.size(); ++line) {
            fields.push_back({line, 1, word == "NODE" ? IdKind::node : IdKind::element});
            for (int corner = 0; corner < corners; ++corner)
                fields.push_back({line, 11 + 10 * corner, IdKind::node});
        }
        return true;
    }
    if (word == "TH") {
        append_history(card, fields);
        return true;
    }
    if (is_list(card)) {
        append_lists(card, fields);
        return true;
    }
    const auto& table = fixed_cards();
    auto row = card.words.size() > 1 ? table.find(word + "/" + card.words[1]) : table.end();
    if (row == table.end()) row = table.find(word);
    if (row == table.end()) return false;
    for (const Column& column : row->second)
        fields.push_back({1, column.first, column.kind});
    return true;
}

}  // namespace type21
