#include "interface_fixture.h"

#include <filesystem>
#include <fstream>
#include <unistd.h>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/model/interface_fields.h"
#include "reference/model/resolve_interfaces.h"

namespace type21::test {

std::vector<std::string> card_lines(const Fields& fields) {
    Fields all{{"surf_IDs", "1"}, {"surf_IDm", "2"}, {"IDrby", "5"}};
    for (const auto& [name, text] : fields)
        all[name] = text;
    std::vector<std::string> lines(12, std::string(100, ' '));
    for (const auto& [name, text] : all) {
        bool known = false;
        for (const InterfaceField& field : interface_fields()) {
            if (field.name != name) continue;
            known = true;
            const auto start = static_cast<size_t>(field.last) - text.size();
            lines[static_cast<size_t>(field.line) - 1].replace(start, text.size(), text);
        }
        EXPECT_TRUE(known) << "the test names an unknown field " << name;
    }
    return lines;
}

std::string card_text(const Fields& fields, const std::string& keyword) {
    return fmt::format("{}\ncontact of the test\n{}\n", keyword, fmt::join(card_lines(fields), "\n"));
}

Deck deck_of(const std::string& cards) {
    static int number = 0;
    const auto path =
        std::filesystem::temp_directory_path() / fmt::format("type21_card_{}_{}_0000.rad", getpid(), number++);
    std::ofstream(path) << "#RADIOSS STARTER\n/BEGIN\ntest\n      2025         0\n"
                        << fmt::format("{:>20}{:>20}{:>20}\n{:>20}{:>20}{:>20}\n", "Mg", "mm", "s", "Mg", "mm", "s")
                        << cards << "/END\n";
    Problems problems;
    Deck deck = read_deck(path.string(), problems);
    std::filesystem::remove(path);
    EXPECT_FALSE(problems.has_errors()) << (problems.list().empty() ? "" : to_text(problems.list().front()));
    return deck;
}

namespace {

void add_node(Model& model, Id id, Vec3 position) {
    model.nodes.index[id] = model.nodes.size();
    model.nodes.id.push_back(id);
    model.nodes.position.push_back(position);
    model.nodes.line.push_back(0);
    model.nodal_mass.push_back(0.001 * model.nodes.size());
}

void add_shell(Model& model, std::array<int, 4> nodes, int part, double thickness, size_t surface) {
    Shell shell;
    shell.id = static_cast<Id>(model.shells.size()) + 1;
    shell.node = nodes;
    shell.part = part;
    shell.thickness = thickness;
    model.surfaces[surface].segments.push_back({nodes, static_cast<int>(model.shells.size())});
    model.shells.push_back(shell);
}

}  // namespace

Model blank_over_tool() {
    Model model;
    model.version = 2025;
    model.units = {1e3, 1e-3, 1.0, "Mg", "mm", "s"};
    model.input_units = model.units;
    model.materials.resize(2);
    model.materials[0].law = MaterialLaw::elastic;
    model.materials[0].young = 200000;
    model.materials[1].law = MaterialLaw::none;
    model.materials[1].young = 1000;
    model.parts.resize(3);
    for (size_t part = 0; part < 3; ++part)
        model.parts[part].material = part == 2 ? 1 : 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            add_node(model, 1001 + 3 * row + column, {10.0 * column, 10.0 * row, 0});
    add_node(model, 2001, {-5, -5, -2});
    add_node(model, 2002, {25, -5, -2});
    add_node(model, 2003, {25, 25, -2});
    add_node(model, 2004, {-5, 25, -2});
    add_node(model, 3001, {10, 10, -20});
    model.surfaces.resize(2);
    model.surfaces[0].id = 1;
    model.surfaces[1].id = 2;
    add_shell(model, {0, 1, 4, 3}, 0, 1.0, 0);
    add_shell(model, {1, 2, 5, 4}, 1, 1.4, 0);
    add_shell(model, {3, 4, 7, 6}, 0, 1.0, 0);
    add_shell(model, {4, 5, 8, 7}, 1, 1.4, 0);
    add_shell(model, {9, 10, 11, 12}, 2, 7.0, 1);
    RigidBody body;
    body.id = 5;
    body.main_node = 13;
    body.nodes = {9, 10, 11, 12};
    model.rigid_bodies.push_back(body);
    return model;
}

Model thermal_blank_over_tool() {
    Model model = blank_over_tool();
    model.nodal_heat_capacity.assign(model.nodes.id.size(), 0.5);
    model.nodal_heat_capacity.back() = 0;  // main node 3001 is in no shell
    model.functions.push_back({3, "", {0.0}, {2.0}});
    model.functions.push_back({4, "", {0.0, 1.0}, {1.0, 0.0}});
    return model;
}

Interface resolve_card(Model& model, const std::string& text, Problems& problems) {
    const Deck deck = deck_of(text);
    resolve_interfaces(deck, model, problems);
    EXPECT_FALSE(model.interfaces.empty());
    return model.interfaces.empty() ? Interface{} : model.interfaces.back();
}

Interface resolve_fields(Model& model, const Fields& fields, Problems& problems) {
    return resolve_card(model, card_text(fields), problems);
}

std::vector<Problem> about(const Problems& problems, const std::string& field, Severity severity) {
    std::vector<Problem> found;
    for (const Problem& problem : problems.list())
        if (problem.severity == severity && (field.empty() || problem.field == field)) found.push_back(problem);
    return found;
}

}  // namespace type21::test
