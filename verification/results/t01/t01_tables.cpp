#include "verification/results/t01/t01_tables.h"

#include <filesystem>

#include <fmt/format.h>

#include "verification/results/t01/t01_columns.h"

namespace type21 {
namespace {

/// Half a unit in the last place of a float, relative.
constexpr double float_rounding = 0x1p-24;

struct KnownVariable {
    size_t index = 0;  ///< in T01Group::variables
    std::string name;
};

std::vector<KnownVariable> known_variables(const T01Group& group, T01Tables& out) {
    std::vector<KnownVariable> known;
    std::string unknown;
    for (size_t v = 0; v < group.variables.size(); ++v) {
        const int code = group.variables[v];
        const std::string_view name =
            group.type == T01Group::interface ? interface_variable(code) : node_variable(code);
        if (name.empty()) {
            unknown += fmt::format("{}{}", unknown.empty() ? "" : ", ", code);
        } else {
            known.push_back({v, std::string(name)});
        }
    }
    if (!unknown.empty())
        out.notes.push_back(fmt::format("group {} '{}': variables with the codes {} left out, {}", group.id,
                                        group.title, unknown,
                                        group.type == T01Group::interface ? "a contact of TYPE21 does not fill them"
                                                                          : "their meaning is not known"));
    return known;
}

class Tables {
  public:
    explicit Tables(const T01File& file) : file_(file), name_(std::filesystem::path(file.file).filename().string()) {}

    T01Tables make() {
        for (const T01Group& group : file_.groups) {
            if (!group.kept()) {
                out_.notes.push_back(
                    fmt::format("group {} '{}' left out: {}", group.id, group.title,
                                group.type == T01Group::rigid_body
                                    ? "OpenRadioss leaves the contact forces of TYPE21 out of rigid bodies"
                                    : "neither nodes nor interfaces"));
                continue;
            }
            const std::vector<KnownVariable> known = known_variables(group, out_);
            if (known.empty() || group.objects.empty()) continue;
            if (group.type == T01Group::node) {
                add_nodes(group, known);
            } else {
                for (size_t object = 0; object < group.objects.size(); ++object)
                    add_interface(group, object, known);
            }
        }
        return std::move(out_);
    }

  private:
    CsvTable empty() const {
        CsvTable table;
        table.file = file_.file;
        if (file_.storage.real_bytes == 4) {
            table.rounding = float_rounding;
            table.rounded_to = "single precision";
        }
        return table;
    }

    void add_nodes(const T01Group& group, const std::vector<KnownVariable>& known) {
        CsvTable table = empty();
        table.has_object = true;
        table.object_name = "node";
        for (size_t t = 0; t < file_.time.size(); ++t) {
            table.time.insert(table.time.end(), group.objects.size(), file_.time[t]);
            table.object.insert(table.object.end(), group.objects.begin(), group.objects.end());
        }
        for (const KnownVariable& variable : known) {
            std::vector<double> values;
            for (size_t t = 0; t < file_.time.size(); ++t)
                for (size_t object = 0; object < group.objects.size(); ++object)
                    values.push_back(group.value(t, object, variable.index));
            add_column(table, variable.name, std::move(values));
        }
        out_.tables.push_back(
            {fmt::format("{}, nodes of group {} '{}'", name_, group.id, group.title), "nodes.csv", std::move(table)});
    }

    void add_interface(const T01Group& group, size_t object, const std::vector<KnownVariable>& known) {
        CsvTable& table = table_of(group.objects[object]);
        for (const KnownVariable& variable : known) {
            std::vector<double> values;
            for (size_t t = 0; t < file_.time.size(); ++t)
                values.push_back(group.value(t, object, variable.index));
            add_column(table, variable.name, std::move(values));
        }
    }

    CsvTable& table_of(Id interface) {
        const std::string ours = fmt::format("interface_{}.csv", interface);
        for (T01Table& table : out_.tables)
            if (table.ours == ours) return table.table;
        CsvTable table = empty();
        table.time = file_.time;
        out_.tables.push_back({fmt::format("{}, interface {}", name_, interface), ours, std::move(table)});
        return out_.tables.back().table;
    }

    /// A variable that two groups ask for has one value: it is kept once.
    static void add_column(CsvTable& table, const std::string& name, std::vector<double> values) {
        if (table.column(name)) return;
        table.columns.push_back(name);
        table.values.push_back(std::move(values));
    }

    const T01File& file_;
    std::string name_;
    T01Tables out_;
};

}  // namespace

T01Tables tables_of(const T01File& file) {
    return Tables(file).make();
}

}  // namespace type21
