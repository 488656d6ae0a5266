#include "verification/support/json_reader.h"

#include <cctype>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/support/nearest_word.h"
#include "verification/support/shown_text.h"

namespace type21 {

std::string json_place(const std::string& place, std::string_view key) {
    std::string part;
    for (const char c : shown(key)) {
        if (c == '~') {
            part += "~0";
        } else if (c == '/') {
            part += "~1";
        } else {
            part += c;
        }
    }
    return (place == "/" ? "" : place) + "/" + part;
}

std::string json_place(const std::string& place, size_t index) {
    return fmt::format("{}/{}", place == "/" ? "" : place, index);
}

std::string shown_json(const nlohmann::json& json) {
    if (json.is_string()) return fmt::format("\"{}\"", shown(json.get_ref<const std::string&>()));
    if (json.is_array()) return fmt::format("a list of {} {}", json.size(), json.size() == 1 ? "value" : "values");
    if (json.is_object()) return fmt::format("an object with {} {}", json.size(), json.size() == 1 ? "key" : "keys");
    return json.dump();
}

JsonReader::~JsonReader() {
    if (complaints_ > most_complaints)
        problems_.push_back(fmt::format("{}: {} more problems", name_, complaints_ - most_complaints));
}

void JsonReader::complain(const std::string& place, const std::string& what) {
    if (++complaints_ <= most_complaints)
        problems_.push_back(fmt::format("{}: {}: {}", name_, place.empty() ? "/" : place, what));
}

bool JsonReader::object(const Json& json, const std::string& place, const Keys& known) {
    if (!json.is_object()) {
        complain(place, fmt::format("{} stands where an object is wanted, with the keys {}", shown_json(json),
                                    fmt::join(known, ", ")));
        return false;
    }
    for (const auto& [key, value] : json.items()) {
        bool is_known = false;
        for (const std::string_view one : known)
            is_known = is_known || one == key;
        if (is_known) continue;
        const std::string_view nearest = nearest_word(key, known);
        complain(
            json_place(place, key),
            fmt::format("there is no such key{}; the keys are {}",
                        nearest.empty() ? "" : fmt::format(", did you mean '{}'?", nearest), fmt::join(known, ", ")));
    }
    return true;
}

const nlohmann::json* JsonReader::member(const Json& object, const char* key, const std::string& place,
                                         std::string_view what) {
    if (object.is_object())
        if (const auto found = object.find(key); found != object.end()) return &*found;
    complain(place, fmt::format("'{}' is missing; it is {}", key, what));
    return nullptr;
}

const nlohmann::json& JsonReader::list(const Json& object, const char* key, const std::string& place) {
    static const Json none = Json::array();
    const Json* found = member(object, key, place, "a list");
    if (!found) return none;
    if (found->is_array()) return *found;
    complain(json_place(place, key), fmt::format("{} stands where a list is wanted", shown_json(*found)));
    return none;
}

double JsonReader::number(const Json& json, const std::string& place) {
    if (json.is_number()) return json.get<double>();
    if (json.is_string()) {
        const std::string& text = json.get_ref<const std::string&>();
        char* end = nullptr;
        const double value = std::strtod(text.c_str(), &end);
        const bool whole = !text.empty() && std::isspace(static_cast<unsigned char>(text[0])) == 0 &&
                           end == text.c_str() + text.size();
        if (whole && std::isfinite(value)) return value;
    }
    complain(place, fmt::format("{} is not a finite number; write a hex float such as \"0x1.8p+1\"", shown_json(json)));
    return 0;
}

long JsonReader::integer(const Json& json, const std::string& place, long low, long high, std::string_view what) {
    // A number of 20 digits is unsigned and would wrap as a long.
    const bool fits =
        json.is_number_integer() &&
        (!json.is_number_unsigned() || json.get<unsigned long>() <= static_cast<unsigned long>(high < 0 ? 0 : high));
    if (fits && json.get<long>() >= low && json.get<long>() <= high) return json.get<long>();
    complain(place, fmt::format("{} is not {} {} to {}", shown_json(json), what, low, high));
    return low;
}

std::string JsonReader::text(const Json& json, const std::string& place) {
    if (json.is_string()) return json.get<std::string>();
    complain(place, fmt::format("{} stands where a text is wanted", shown_json(json)));
    return "";
}

}  // namespace type21
