/// @file Line count, fields by their table, and a word on columns that nobody reads.
#include "reference/model/read_interface_card.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "reference/model/interface_fields.h"
#include "reference/model/numbers.h"

namespace type21 {
namespace {

constexpr int card_lines = 12;
constexpr int columns = 100;
constexpr int last_version_with_multimp = 2016;  ///< the layout of 2017 has its columns blank

bool has_twelve_lines(CardReader& card) {
    const auto lines = static_cast<int>(card.line_count()) - 1;
    if (lines < card_lines) {
        card.error(-1, "", fmt::format("{} data lines after the title", std::max(lines, 0)),
                   "the card has always twelve data lines",
                   "Keep the lines whose fields are all unused as blank lines");
        return false;
    }
    for (int extra = card_lines + 1; extra <= lines; ++extra) {
        if (card.blank(static_cast<size_t>(extra), 1, columns)) continue;
        card.error(extra, "", card.text(static_cast<size_t>(extra), 1, columns),
                   fmt::format("the card ends after twelve data lines; this is line {}", extra),
                   "Take the line that is too many out");
        return false;
    }
    return true;
}

int flag(CardReader& card, const InterfaceField& field) {
    const Id value = card.integer(static_cast<size_t>(data_line(field.line)), field.first, field.last, field.name);
    // A flag that does not fit is out of every range; saturated it stays out.
    return static_cast<int>(std::clamp<Id>(value, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()));
}

/// Digits for X, Y, Z in columns 8, 9, 10. @return 4 x + 2 y + z
int release_code(CardReader& card, const InterfaceField& field) {
    const int line = data_line(field.line);
    int code = 0;
    bool good = card.blank(static_cast<size_t>(line), 1, field.first - 1);
    card.skip(static_cast<size_t>(line), 1, field.last);
    for (int column = field.first; column <= field.last; ++column) {
        const std::string digit = card.text(static_cast<size_t>(line), column, column);
        good = good && (digit.empty() || digit == " " || digit == "0" || digit == "1");
        code = 2 * code + (digit == "1" ? 1 : 0);
    }
    if (!good)
        card.error(line, field.name, card.text(static_cast<size_t>(line), 1, field.last),
                   "three digits 0 or 1 for X, Y, Z in columns 8, 9, 10", "Write for example 001 there to release Z");
    return good ? code : 0;
}

struct Reading {
    CardReader& card;
    const InterfaceField& field;
    const Interface& interface;

    void operator()(Sourced<int>& value) const {
        value.value = field.name == "IBC" ? release_code(card, field) : flag(card, field);
    }
    void operator()(Sourced<Id>& value) const {
        value.value = card.integer(static_cast<size_t>(data_line(field.line)), field.first, field.last, field.name);
    }
    void operator()(Sourced<double>& value) const {
        value.value = card.real(static_cast<size_t>(data_line(field.line)), field.first, field.last, field.name,
                                dimension(field, interface));
    }
};

/// True for 0 and for the value that 0 stands for: reading or not reading it is the same.
bool means_its_default(const CardReader& card, const InterfaceField& field) {
    double value = 0;
    if (parse_real(card.text(static_cast<size_t>(data_line(field.line)), field.first, field.last), value) !=
        NumberFault::none)
        return true;  // what is no number has had its message
    return value == 0 || (field.name == "AscaleF" && value == 1) || (field.name == "Pskid" && value >= no_limit);
}

void read_field(CardReader& card, const InterfaceField& field, int version, Interface& interface) {
    const auto line = static_cast<size_t>(data_line(field.line));
    const bool blank = card.blank(line, field.first, field.last);
    Origin origin{Origin::Kind::deck, card.line_number(line), ""};
    if (version < field.since) {
        // As if its columns were blank: the default takes the place of 0 afterwards.
        with_field(interface, field, [](auto& value) { value.value = {}; });
        origin = {Origin::Kind::absent, 0, fmt::format("read from version {} on", field.since)};
        card.unused(line, field.first, field.last, field.last - field.first + 1);
        if (!blank && !means_its_default(card, field))
            card.warning(data_line(field.line), field.name, card.text(line, field.first, field.last),
                         fmt::format("is ignored: version {} of /BEGIN does not have it, it is read from version {} on",
                                     version, field.since),
                         "Raise the version of /BEGIN or leave the columns blank");
    } else {
        with_field(interface, field, Reading{card, field, interface});
        if (blank) origin = {Origin::Kind::fallback, card.line_number(line), "blank means 0"};
    }
    with_field(interface, field, [&](auto& value) { value.origin = origin; });
}

void note_multimp(CardReader& card, int version) {
    const auto line = static_cast<size_t>(data_line(1));
    if (version <= last_version_with_multimp) card.unused(line, 51, 60, 10);
    if (version > last_version_with_multimp || card.blank(line, 51, 60)) return;
    card.warning(data_line(1), "Multimp", card.text(line, 51, 60),
                 "has no effect: the memory for candidates is found by itself", "Leave columns 51 to 60 blank");
}

}  // namespace

bool read_interface_card(CardReader& card, int version, Interface& interface) {
    if (!has_twelve_lines(card)) return false;
    // The dimension of some reals depends on flags that stand behind them: integers first.
    for (const bool reals : {false, true})
        for (const InterfaceField& field : interface_fields())
            if (with_field(interface, field, [](auto& value) {
                    return std::is_same_v<std::decay_t<decltype(value.value)>, double>;
                }) == reals)
                read_field(card, field, version, interface);
    note_multimp(card, version);
    card.finish();
    return true;
}

}  // namespace type21
