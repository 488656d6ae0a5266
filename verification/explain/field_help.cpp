#include "verification/explain/field_help.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>

#include "reference/model/field_table.h"
#include "verification/explain/blank_card.h"

namespace type21 {
namespace {

constexpr size_t text_width = 96;

bool same_word(std::string_view one, std::string_view other) {
    return std::equal(one.begin(), one.end(), other.begin(), other.end(),
                      [](unsigned char a, unsigned char b) { return std::tolower(a) == std::tolower(b); });
}

/// "label     text", the text wrapped and indented.
std::string entry(std::string_view label, std::string_view text) {
    std::string out;
    size_t begin = 0;
    do {
        size_t end = text.size();
        if (end - begin > text_width) {
            end = text.rfind(' ', begin + text_width);
            if (end == std::string_view::npos || end <= begin) end = std::min(begin + text_width, text.size());
        }
        out += fmt::format("{:<10}  {}\n", begin == 0 ? label : "", text.substr(begin, end - begin));
        begin = end + 1;
    } while (begin < text.size());
    return out;
}

const InterfaceField& card_field(std::string_view name) {
    const auto& fields = interface_fields();
    return *std::find_if(fields.begin(), fields.end(), [&](const InterfaceField& f) { return f.name == name; });
}

/// "m", or "Istf 0: -, Istf 1: N/m" if the unit depends on a flag.
std::string unit_words(const InterfaceField& field) {
    const UnitSystem si;
    const auto unit = [&](const Interface& card) {
        if (field.name == "Angladm") return std::string("deg");
        const std::string name = si.name(dimension(field, card));
        return name.empty() ? std::string("-") : name;
    };
    const auto by_flag = [&](std::string_view flag, int last, void (*set)(Interface&, int)) {
        std::string out;
        bool differ = false;
        Interface card;
        for (int value = 0; value <= last; ++value) {
            set(card, value);
            differ = differ || unit(card) != unit(Interface{});
            out += fmt::format("{}{} {}: {}", value == 0 ? "" : ", ", flag, value, unit(card));
        }
        return differ ? out : std::string();
    };
    std::string words = by_flag("Istf", 1, [](Interface& it, int v) { it.istf.value = v; });
    words += by_flag("Ifiltr", 3, [](Interface& it, int v) { it.ifiltr.value = v; });
    words += by_flag("Ifric", 4, [](Interface& it, int v) { it.ifric.value = v; });
    words += by_flag("fct_IDK", 1, [](Interface& it, int v) { it.fct_idk.value = v; });
    return words.empty() ? unit(Interface{}) : words;
}

std::string default_words(const InterfaceField& field) {
    // A blank field on a card that uses it.
    const bool adaptive = field.name == "NRadm" || field.name == "Padm";
    const Interface card = blank_card(adaptive ? CardFields{{"Iadm", "2"}, {"Angladm", "30.0"}} : CardFields{});
    const Origin origin = with_field(card, field, [](const auto& value) { return value.origin; });
    if (field.name == "surf_IDs" || field.name == "surf_IDm" || field.name == "IDrby") return "none; it must be given";
    for (const FieldRow& row : field_table(card, UnitSystem{}))
        if (row.name == field.name) {
            // A default that depends on the mesh has no fixed value.
            if (field.name == "DEPTH" || field.name == "Gapmin") return origin.why;
            return origin.why.empty() ? row.value : fmt::format("{} ({})", row.value, origin.why);
        }
    return "";
}

std::string case_words(std::string_view cover, std::span<const CaseCover> cases) {
    std::string out;
    for (const CaseCover& a_case : cases)
        if (std::find(a_case.covers.begin(), a_case.covers.end(), cover) != a_case.covers.end())
            out += (out.empty() ? "" : ", ") + a_case.name;
    if (!out.empty()) return out;
    return cases.empty() ? "unknown: no folder of cases here (see --cases)" : "none";
}

std::string departure_words(Departure departure) {
    for (const DepartureRow& row : departures())
        if (row.id == departure)
            return fmt::format("{} ({}): {}", name(row.id), row.available ? "--as-built" : "not available",
                               row.as_built);
    return "";
}

}  // namespace

const std::vector<FieldHelp>& field_help() {
    static const std::vector<FieldHelp> all = [] {
        std::vector<FieldHelp> out = field_help_surfaces();
        for (auto part : {field_help_friction(), field_help_heat()})
            out.insert(out.end(), part.begin(), part.end());
        return out;
    }();
    return all;
}

const FieldHelp* find_field_help(std::string_view name) {
    for (const FieldHelp& help : field_help())
        if (same_word(help.name, name)) return &help;
    return nullptr;
}

std::string field_text(const FieldHelp& help, std::span<const CaseCover> cases) {
    const InterfaceField& field = card_field(help.name);
    std::string out = entry(help.name, help.meaning);
    out += entry("card", fmt::format("line {}, columns {} to {}", field.line, field.first, field.last));
    if (field.since > 120) out += entry("since", fmt::format("version {} of /BEGIN", field.since));
    out += entry("SI unit", unit_words(field));
    out += entry("default", default_words(field));
    out += entry("rule", help.rule);
    out += entry("source", help.source);
    if (help.departures.empty()) out += entry("as built", "as documented");
    bool first = true;
    for (const Departure departure : help.departures) {
        out += entry(first ? "as built" : "", departure_words(departure));
        first = false;
    }
    return out + entry("cases", case_words(fmt::format("field {}", help.name), cases));
}

std::string departure_text(const DepartureRow& row, std::span<const CaseCover> cases) {
    std::string out =
        entry(name(row.id), row.available ? "can be switched on with --as-built" : "cannot be switched on");
    out += entry("documented", row.documented) + entry("as built", row.as_built);
    if (!row.reason.empty()) out += entry("because", row.reason);
    std::string fields;
    for (const FieldHelp& help : field_help())
        if (std::find(help.departures.begin(), help.departures.end(), row.id) != help.departures.end())
            fields += fmt::format("{}{}", fields.empty() ? "" : ", ", help.name);
    out += entry("fields", fields.empty() ? "none; it concerns every contact" : fields);
    return out + entry("cases", case_words("departure " + name(row.id), cases));
}

}  // namespace type21
