#include "verification/support/json_file.h"

#include <algorithm>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "verification/support/json_reader.h"
#include "verification/support/shown_text.h"

namespace type21 {
namespace {

using Json = nlohmann::json;

/// Levels are nested deeper than allowed.
struct TooDeep {};

/// Follows the parser: the place it has reached, and keys that come twice.
class Follower {
  public:
    /// @param complaints  a message for each key that is there twice
    Follower(const std::string& name, std::vector<std::string>& complaints) : name_(name), complaints_(complaints) {}

    bool operator()(int depth, Json::parse_event_t event, const Json& parsed) {
        switch (event) {
            case Json::parse_event_t::object_start:
            case Json::parse_event_t::array_start:
                if (depth >= deepest_json) throw TooDeep();
                levels_.push_back({event == Json::parse_event_t::array_start, 0, "", {}});
                break;
            case Json::parse_event_t::object_end:
            case Json::parse_event_t::array_end:
                levels_.pop_back();
                end_value();
                break;
            case Json::parse_event_t::key:
                key(parsed.get_ref<const std::string&>());
                break;
            case Json::parse_event_t::value:
                end_value();
                break;
        }
        return true;
    }

    /// A JSON pointer to the value that the parser reads.
    std::string place() const {
        std::string out;
        for (const Level& level : levels_) {
            if (!level.is_list && level.key.empty()) break;
            out = json_place(out, level.is_list ? fmt::format("{}", level.index) : level.key);
        }
        return out.empty() ? "/" : out;
    }

  private:
    struct Level {
        bool is_list;
        size_t index;
        std::string key;
        std::set<std::string> keys;
    };

    void end_value() {
        if (!levels_.empty() && levels_.back().is_list) ++levels_.back().index;
    }
    void key(const std::string& key) {
        Level& level = levels_.back();
        level.key = key;
        if (level.keys.insert(key).second) return;
        complaints_.push_back(fmt::format("{}: {}: the key is there twice", name_, place()));
    }

    const std::string& name_;
    std::vector<std::string>& complaints_;
    std::vector<Level> levels_;
};

std::string line_and_column(std::string_view text, size_t byte) {
    text = text.substr(0, std::min(byte, text.size()));
    const auto lines = std::count(text.begin(), text.end(), '\n');
    const size_t begin = text.rfind('\n');
    return fmt::format("{}:{}", lines + 1, text.size() - (begin == std::string_view::npos ? 0 : begin + 1));
}

/// What the parser says, without its own place and number.
std::string reason(const Json::exception& error) {
    std::string_view what = error.what();
    for (const std::string_view before : {"] ", "column ", ": "})
        if (const size_t at = what.find(before); at != std::string_view::npos) what.remove_prefix(at + before.size());
    return shown(what, 160);
}

bool is_utf16(std::string_view text) {
    return text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF") ||
           text.substr(0, 4).find('\0') != std::string_view::npos;
}

}  // namespace

std::optional<Json> parse_json(std::string_view text, const std::string& name, std::vector<std::string>& problems) {
    const size_t before = problems.size();
    if (is_utf16(text)) {
        problems.push_back(fmt::format("{}: is UTF-16 or no text; JSON is UTF-8", name));
        return std::nullopt;
    }
    Follower follower(name, problems);
    try {
        // By reference: the parser copies its callback.
        Json json = Json::parse(text, [&follower](int depth, Json::parse_event_t event, Json& parsed) {
            return follower(depth, event, parsed);
        });
        if (problems.size() > before) return std::nullopt;
        return json;
    } catch (const TooDeep&) {
        problems.push_back(fmt::format("{}: {}: more than {} lists and objects inside each other", name,
                                       shown(follower.place()), deepest_json));
    } catch (const Json::parse_error& error) {
        problems.push_back(fmt::format("{}:{}: {}: is not JSON: {}", name, line_and_column(text, error.byte),
                                       follower.place(), reason(error)));
    } catch (const Json::out_of_range& error) {
        const std::string_view what = error.what();
        const size_t quote = what.find('\'');
        problems.push_back(fmt::format("{}: {}: {} is too large for a double", name, follower.place(),
                                       quote == std::string_view::npos ? "a number" : shown(what.substr(quote))));
    }
    return std::nullopt;
}

std::optional<Json> read_json(const std::filesystem::path& file, std::vector<std::string>& problems) {
    const std::string name = shown(file.string(), 400);
    std::ifstream stream(file, std::ios::binary);
    std::error_code error;
    if (!stream || std::filesystem::is_directory(file, error)) {
        problems.push_back(fmt::format("{}: cannot be read", name));
        return std::nullopt;
    }
    // In pieces: a device or a pipe has no size.
    constexpr size_t piece = size_t{1} << 20;
    std::string text;
    while (stream) {
        const size_t have = text.size();
        text.resize(have + piece);
        stream.read(text.data() + have, static_cast<std::streamsize>(piece));
        text.resize(have + static_cast<size_t>(stream.gcount()));
        if (text.size() > largest_json) {
            problems.push_back(fmt::format("{}: has more than {} bytes; split it", name, largest_json));
            return std::nullopt;
        }
        if (is_utf16(text)) break;
    }
    return parse_json(text, name, problems);
}

}  // namespace type21
