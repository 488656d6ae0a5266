#include "verification/criteria/cases/covers.h"

#include <algorithm>
#include <charconv>

#include "reference/contract/departures.h"
#include "reference/model/interface_fields.h"

namespace type21 {
namespace {

bool is_number_up_to(std::string_view text, int last) {
    int number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc{} && end == text.data() + text.size() && number >= 1 && number <= last;
}

}  // namespace

bool is_cover(std::string_view text) {
    const size_t space = text.find(' ');
    if (space == std::string_view::npos) return false;
    const std::string_view kind = text.substr(0, space);
    const std::string_view what = text.substr(space + 1);
    if (kind == "eq") return is_number_up_to(what, manual_equations);
    if (kind == "comment") return is_number_up_to(what, manual_comments);
    if (kind == "field")
        return std::any_of(interface_fields().begin(), interface_fields().end(),
                           [&](const InterfaceField& field) { return field.name == what; });
    if (kind == "departure")
        return std::any_of(departures().begin(), departures().end(),
                           [&](const DepartureRow& row) { return name(row.id) == what; });
    return false;
}

}  // namespace type21
