#include "verification/results/compare/header_name.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <vector>

#include "verification/results/record/node_columns.h"
#include "verification/results/t01/t01_columns.h"

namespace type21 {
namespace {

std::string upper(std::string_view text) {
    std::string out(text);
    std::transform(out.begin(), out.end(), out.begin(), [](unsigned char c) { return std::toupper(c); });
    return out;
}

bool is_interface_column(const std::string& name) {
    for (int code = 1; code < 30; ++code)
        if (!name.empty() && interface_variable(code) == name) return true;
    return false;
}

bool is_node_column(const std::string& name) {
    return std::any_of(node_columns().begin(), node_columns().end(),
                       [&](const NodeColumn& column) { return column.name == name; });
}

/// What only rbody.csv has.
bool is_body_column(const std::string& name) {
    for (const char* own : {"FX", "FY", "FZ", "MX", "MY", "MZ"})
        if (name == own) return true;
    return false;
}

std::optional<Id> whole_number(std::string_view text) {
    Id id = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), id);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return id;
}

std::vector<std::string_view> words_of(std::string_view text, std::string_view separators) {
    std::vector<std::string_view> words;
    for (size_t at = 0; at < text.size();) {
        const size_t begin = text.find_first_not_of(separators, at);
        if (begin == std::string_view::npos) break;
        at = std::min(text.find_first_of(separators, begin), text.size());
        words.push_back(text.substr(begin, at - begin));
    }
    return words;
}

enum class ObjectKind { unknown, interface, node, body };

ObjectKind kind_of(std::string_view word) {
    const std::string name = upper(word);
    for (const char* one : {"INTER", "INTERFACE", "TH/INTER", "/TH/INTER", "CONTACT"})
        if (name == one) return ObjectKind::interface;
    for (const char* one : {"NODE", "NOD", "TH/NODE", "/TH/NODE"})
        if (name == one) return ObjectKind::node;
    for (const char* one : {"RBODY", "TH/RBODY", "/TH/RBODY", "RBOD"})
        if (name == one) return ObjectKind::body;
    return ObjectKind::unknown;
}

/// "INTER1": the word and its number.
void split_number(std::string_view word, std::vector<std::string_view>& out) {
    const size_t digits = word.find_last_not_of("0123456789") + 1;
    if (digits > 0 && digits < word.size() && kind_of(word.substr(0, digits)) != ObjectKind::unknown) {
        out.push_back(word.substr(0, digits));
        out.push_back(word.substr(digits));
    } else {
        out.push_back(word);
    }
}

struct HeaderWords {
    ObjectKind kind = ObjectKind::unknown;
    std::optional<Id> id;
    std::string column;  ///< a name, or empty when only a code is there
    int code = 0;        ///< of the time-history format
    std::string title;   ///< the words that are left
};

/// Takes the variable out of the words: the last one, behind the last of "_.-" in it, or the first.
void take_variable(std::vector<std::string_view>& words, HeaderWords& out) {
    const size_t count = words.size();
    if (count >= 2 && upper(words[count - 2]) == "VAR") {
        if (const auto code = whole_number(words[count - 1]); code && *code > 0 && *code < 100000) {
            out.code = static_cast<int>(*code);
            words.resize(count - 2);
            return;
        }
    }
    if (out.column = known_column(words.back()); !out.column.empty()) return words.pop_back();
    const std::string_view last = words.back();
    if (const size_t cut = last.find_last_of("_.-"); cut != std::string_view::npos && cut > 0) {
        if (out.column = known_column(last.substr(cut + 1)); !out.column.empty()) {
            words.pop_back();
            for (const std::string_view part : words_of(last.substr(0, cut), "_"))
                words.push_back(part);
            return;
        }
    }
    if (out.column = known_column(words.front()); !out.column.empty()) words.erase(words.begin());
}

HeaderWords read_words(std::string_view header) {
    HeaderWords out;
    std::vector<std::string_view> words = words_of(header, " \t:,;()[]#\"'=");
    if (words.empty()) return out;
    take_variable(words, out);
    std::vector<std::string_view> parts;
    for (const std::string_view word : words)
        split_number(word, parts);
    std::optional<size_t> id;
    for (size_t i = 0; i < parts.size(); ++i) {
        if (kind_of(parts[i]) != ObjectKind::unknown && out.kind == ObjectKind::unknown) {
            out.kind = kind_of(parts[i]);
            if (i + 1 < parts.size() && whole_number(parts[i + 1])) id = i + 1;
        }
    }
    if (!id && !parts.empty() && whole_number(parts.front())) id = 0;
    for (size_t i = parts.size(); !id && i-- > 0;)
        if (whole_number(parts[i])) id = i;
    if (id) out.id = whole_number(parts[*id]);
    for (const std::string_view word : words)
        out.title += (out.title.empty() ? "" : " ") + std::string(word);
    return out;
}

ObjectKind kind_by_column(const HeaderWords& words, RunTables& run) {
    if (words.kind != ObjectKind::unknown) return words.kind;
    if (words.column.empty()) {
        const bool both = !interface_variable(words.code).empty() && !node_variable(words.code).empty();
        if (words.id && both) return run.interfaces().contains(*words.id) ? ObjectKind::interface : ObjectKind::node;
        return interface_variable(words.code).empty() ? ObjectKind::node : ObjectKind::interface;
    }
    if (is_interface_column(words.column)) return ObjectKind::interface;
    if (is_body_column(words.column)) return ObjectKind::body;
    const bool body = words.id && run.objects("rbody.csv").contains(*words.id);
    const bool node = words.id && run.objects("nodes.csv").contains(*words.id);
    return body && !node ? ObjectKind::body : ObjectKind::node;
}

std::optional<Id> interface_by_title(const std::string& title, const RunTables& run) {
    std::optional<Id> found;
    for (const auto& [id, known] : run.titles()) {
        if (known.empty() || upper(title).find(upper(known)) == std::string::npos) continue;
        if (found) return std::nullopt;
        found = id;
    }
    if (!found && run.interfaces().size() == 1) return *run.interfaces().begin();
    return found;
}

}  // namespace

std::string known_column(std::string_view text) {
    const std::string name = upper(text);
    return is_interface_column(name) || is_node_column(name) || is_body_column(name) ? name : std::string();
}

std::optional<ColumnPlace> place_of_header(std::string_view header, RunTables& run) {
    HeaderWords words = read_words(header);
    if (words.column.empty() && words.code == 0) return std::nullopt;
    const ObjectKind kind = kind_by_column(words, run);
    if (words.column.empty())
        words.column = kind == ObjectKind::interface ? interface_variable(words.code) : node_variable(words.code);
    if (words.column.empty()) return std::nullopt;
    if (kind == ObjectKind::interface) {
        const std::optional<Id> id = words.id ? words.id : interface_by_title(words.title, run);
        if (!id) return std::nullopt;
        return ColumnPlace{interface_file(*id), std::nullopt, words.column};
    }
    if (!words.id) return std::nullopt;
    return ColumnPlace{kind == ObjectKind::body ? "rbody.csv" : "nodes.csv", words.id, words.column};
}

}  // namespace type21
