#include "verification/results/compare/reference_tables.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <map>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/results/compare/header_name.h"
#include "verification/support/shown_text.h"

namespace type21 {
namespace fs = std::filesystem;
namespace {

/// The length of the first record of a time-history file has zeros among its bytes; a text has none.
bool is_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::array<char, 4> first{};
    file.read(first.data(), first.size());
    const std::string_view bytes(first.data(), static_cast<size_t>(file.gcount()));
    const bool utf16 = bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF");
    return utf16 || bytes.find('\0') == std::string_view::npos;
}

/// "interface_1:FNX", "node_1012:DZ", "rbody_1:VZ" of --map; nothing without a colon.
std::optional<ColumnPlace> place_in_option(const std::string& target) {
    const size_t colon = target.find(':');
    if (colon == std::string::npos) return std::nullopt;
    const std::string object = target.substr(0, colon), column = target.substr(colon + 1);
    if (interface_of(object + ".csv")) return ColumnPlace{object + ".csv", std::nullopt, column};
    for (const auto& [word, file] : {std::pair{"node_", "nodes.csv"}, std::pair{"rbody_", "rbody.csv"}})
        if (object.starts_with(word))
            if (const auto id = interface_of("interface_" + object.substr(std::string_view(word).size()) + ".csv"))
                return ColumnPlace{file, id, column};
    throw WrongOption(
        fmt::format("--map {}=...: write interface_<id>, node_<id> or rbody_<id> before the colon", target));
}

class CsvReference {
  public:
    CsvReference(const fs::path& path, RunTables& run, ReferenceChanger& changer)
        : path_(path), run_(run), changer_(changer), raw_(read_csv(path, {changer.time_name(), false})) {}

    T01Tables tables() {
        for (const std::string& note : raw_.notes)
            out_.notes.push_back(fmt::format("{}: {}", name(), note));
        raw_.notes.clear();
        if (raw_.has_object) {
            one_table();
        } else {
            all_histories();
        }
        return std::move(out_);
    }

  private:
    std::string name() const { return path_.filename().string(); }

    /// Rows of time and object, as ours.
    void one_table() {
        const std::string file = raw_.object_name == "node" ? "nodes.csv" : raw_.object_name + ".csv";
        changer_.rename(raw_);
        changer_.require_targets(run_.columns(file), file);
        match_case(file);
        require_names_once(raw_.columns);
        changer_.convert(raw_, raw_.columns, out_.notes);
        out_.tables.push_back({name(), file, std::move(raw_)});
    }

    /// Rows of time; every column has an object of its own.
    void all_histories() {
        std::vector<std::optional<ColumnPlace>> places;
        std::vector<size_t> bare;
        bool any_object = false;
        for (size_t c = 0; c < raw_.columns.size(); ++c) {
            std::optional<ColumnPlace> place;
            const std::string ours = changer_.mapped(raw_.columns[c], raw_.unit(c));
            if (!ours.empty()) {
                place = place_in_option(ours);
                if (place) {
                    require_ours(*place);
                    any_object = true;
                } else {
                    raw_.columns[c] = ours;
                }
            } else if (known_column(raw_.columns[c]).empty()) {
                place = place_of_header(raw_.columns[c], run_);
                any_object = any_object || place;
            }
            if (!place && (!ours.empty() || !known_column(raw_.columns[c]).empty())) bare.push_back(c);
            places.push_back(std::move(place));
        }
        if (!any_object) add_unknown(places, bare);
        if (!bare.empty()) place_bare(bare, places);
        leave_out(places);
        std::vector<std::string> names;
        for (const auto& place : places)
            names.push_back(place ? place->column : "");
        changer_.convert(raw_, names, out_.notes);
        collect(places);
    }

    /// A column that is not known is compared too, and missed in ours, but for energies of the whole model and such,
    /// whose names have several words: "INTERNAL ENERGY".
    void add_unknown(const std::vector<std::optional<ColumnPlace>>& places, std::vector<size_t>& bare) const {
        const bool some = !bare.empty();
        bare.clear();
        for (size_t c = 0; c < places.size(); ++c) {
            const bool words = raw_.columns[c].find(' ') != std::string::npos && known_column(raw_.columns[c]).empty();
            if (!some || !words) bare.push_back(c);
        }
    }

    /// Columns with our names belong to one interface.
    void place_bare(const std::vector<size_t>& bare, std::vector<std::optional<ColumnPlace>>& places) {
        const std::string file = interface_of_file();
        changer_.require_targets(run_.columns(file), file);
        match_case(file);
        for (const size_t c : bare)
            places[c] = ColumnPlace{file, std::nullopt, raw_.columns[c]};
    }

    std::string interface_of_file() const {
        if (interface_of(name())) return name();
        if (run_.interfaces().size() == 1) return interface_file(*run_.interfaces().begin());
        throw UnclearReference(
            fmt::format("{}: {} has {} interfaces and the name does not say which this is. Name it "
                        "interface_<id>.csv",
                        path_.string(), run_.folder().string(), run_.interfaces().size()));
    }

    /// "fnx" is FNX where ours has that and not the other.
    void match_case(const std::string& file) {
        const std::vector<std::string>& ours = run_.columns(file);
        for (std::string& column : raw_.columns) {
            if (std::find(ours.begin(), ours.end(), column) != ours.end()) continue;
            const std::string known = known_column(column);
            if (std::find(ours.begin(), ours.end(), known) != ours.end()) column = known;
        }
    }

    void require_ours(const ColumnPlace& place) {
        const std::vector<std::string>& columns = run_.columns(place.file);
        if (std::find(columns.begin(), columns.end(), place.column) == columns.end())
            throw WrongOption(fmt::format("--map: {} of the run has no column '{}'; it has {}", place.file,
                                          place.column, listed(columns)));
        if (place.object && !run_.objects(place.file).contains(*place.object))
            throw WrongOption(fmt::format("--map: {} of the run has no object {}", place.file, *place.object));
    }

    void require_names_once(const std::vector<std::string>& names) const {
        std::vector<std::string> sorted = names;
        std::sort(sorted.begin(), sorted.end());
        const auto twice = std::adjacent_find(sorted.begin(), sorted.end());
        if (twice != sorted.end())
            throw CsvError(fmt::format("{}: column '{}' is there twice", raw_.file, shown(*twice)));
    }

    void leave_out(const std::vector<std::optional<ColumnPlace>>& places) {
        std::vector<std::string> left;
        for (size_t c = 0; c < places.size(); ++c)
            if (!places[c]) left.push_back("'" + shown(raw_.columns[c], 40) + "'");
        if (left.empty()) return;
        const size_t count = left.size();
        if (count > 5) left.resize(5);
        out_.notes.push_back(
            fmt::format("{}: {} {} left out, which name no interface or node and variable of a run: "
                        "{}{}; --map says what one is",
                        name(), count, count == 1 ? "column" : "columns", fmt::join(left, ", "),
                        count > left.size() ? ", ..." : ""));
    }

    void collect(const std::vector<std::optional<ColumnPlace>>& places) {
        std::map<std::string, CsvTable> interfaces;
        std::map<std::string, std::map<Id, std::map<std::string, size_t>>> objects;
        for (size_t c = 0; c < places.size(); ++c) {
            if (!places[c]) continue;
            if (places[c]->object) {
                const auto [found, is_new] = objects[places[c]->file][*places[c]->object].emplace(places[c]->column, c);
                if (!is_new) require_same(found->second, c);
                continue;
            }
            CsvTable& table = interfaces[places[c]->file];
            if (const auto there = table.column(places[c]->column)) {
                if (table.values[*there] != raw_.values[c]) complain_twice(c);
                continue;
            }
            table.columns.push_back(places[c]->column);
            table.values.push_back(raw_.values[c]);
        }
        for (auto& [file, table] : interfaces) {
            head(table);
            table.time = raw_.time;
            const std::string label = interfaces.size() == 1 && objects.empty()
                                          ? name()
                                          : fmt::format("{}, {}", name(), file.substr(0, file.size() - 4));
            out_.tables.push_back({label, file, std::move(table)});
        }
        for (const auto& [file, by_id] : objects)
            collect_objects(file, by_id);
    }

    void require_same(size_t first, size_t second) const {
        if (raw_.values[first] != raw_.values[second]) complain_twice(second);
    }
    [[noreturn]] void complain_twice(size_t column) const {
        throw CsvError(
            fmt::format("{}: column '{}' is there twice, with other values", raw_.file, shown(raw_.columns[column])));
    }

    void head(CsvTable& table) const {
        table.file = raw_.file;
        table.rounding = raw_.rounding;
        table.rounded_to = raw_.rounded_to;
    }

    /// One table for all objects that have the same columns.
    void collect_objects(const std::string& file, const std::map<Id, std::map<std::string, size_t>>& by_id) {
        std::map<std::vector<std::string>, std::vector<Id>> groups;
        for (const auto& [id, columns] : by_id) {
            std::vector<std::string> names;
            for (const auto& [column, index] : columns)
                names.push_back(column);
            groups[names].push_back(id);
        }
        for (const auto& [names, ids] : groups) {
            CsvTable table;
            head(table);
            table.has_object = true;
            table.object_name = file == "nodes.csv" ? "node" : "rbody";
            table.columns = names;
            table.values.resize(names.size());
            for (size_t row = 0; row < raw_.rows(); ++row)
                for (const Id id : ids) {
                    table.time.push_back(raw_.time[row]);
                    table.object.push_back(id);
                    for (size_t c = 0; c < names.size(); ++c)
                        table.values[c].push_back(raw_.values[by_id.at(id).at(names[c])][row]);
                }
            out_.tables.push_back(
                {fmt::format("{}, {}", name(), file.substr(0, file.size() - 4)), file, std::move(table)});
        }
    }

    const fs::path path_;
    RunTables& run_;
    ReferenceChanger& changer_;
    CsvTable raw_;
    T01Tables out_;
};

}  // namespace

T01Tables reference_tables(const fs::path& reference, RunTables& run, ReferenceChanger& changer) {
    if (is_text(reference)) return CsvReference(reference, run, changer).tables();
    T01Tables out = tables_of(read_t01(reference));
    for (T01Table& table : out.tables) {
        changer.rename(table.table);
        changer.require_targets(run.columns(table.ours), table.ours);
        changer.convert(table.table, table.table.columns, out.notes);
    }
    return out;
}

}  // namespace type21
