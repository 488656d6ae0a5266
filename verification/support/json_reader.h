/// @file Takes the values of a JSON document by type. Every complaint has file and place.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

namespace type21 {

/// A JSON pointer (RFC 6901) one level deeper; parts that a terminal cannot show are escaped, long ones are cut.
std::string json_place(const std::string& place, std::string_view key);
std::string json_place(const std::string& place, std::size_t index);

/// A value as a message quotes it: numbers and short texts whole, "a list of 3 values", "an object with 2 keys".
std::string shown_json(const nlohmann::json& json);

/// Complaints beyond so many are only counted.
inline constexpr std::size_t most_complaints = 100;

/// A value that is missing or of another type is a complaint and reads as 0 or empty, so that one reading finds all.
class JsonReader {
  public:
    using Json = nlohmann::json;
    using Keys = std::vector<std::string_view>;

    /// @param name      of the file
    /// @param problems  every complaint: "decide.json: /blocks/0/nodes/3/1: \"nan\" is not a finite number"
    JsonReader(std::string name, std::vector<std::string>& problems) : name_(std::move(name)), problems_(problems) {}
    /// Says how many complaints were left out.
    ~JsonReader();
    JsonReader(const JsonReader&) = delete;
    JsonReader& operator=(const JsonReader&) = delete;

    void complain(const std::string& place, const std::string& what);
    bool ok() const { return complaints_ == 0; }

    /// @param known  all its keys; another one is a complaint with the nearest of them
    /// @return false when the value is no object
    bool object(const Json& json, const std::string& place, const Keys& known);
    /// @param what  it is, for the message when it is missing: "a length"
    /// @return nullptr when it is missing
    const Json* member(const Json& object, const char* key, const std::string& place, std::string_view what);
    /// The list under a key; empty when it is missing or no list.
    const Json& list(const Json& object, const char* key, const std::string& place);
    /// A plain number or a hex float in a string, finite.
    double number(const Json& json, const std::string& place);
    /// A whole number from `low` to `high`.
    /// @param what  it is, for messages
    long integer(const Json& json, const std::string& place, long low, long high,
                 std::string_view what = "a whole number from");
    std::string text(const Json& json, const std::string& place);

  private:
    std::string name_;
    std::vector<std::string>& problems_;
    std::size_t complaints_ = 0;
};

}  // namespace type21
