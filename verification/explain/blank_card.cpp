#include "verification/explain/blank_card.h"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <fmt/format.h>

#include "reference/model/interface_fields.h"
#include "reference/model/resolve_interfaces.h"

namespace type21 {
namespace {

constexpr int card_lines = 12;

std::string card_text(const CardFields& fields) {
    std::vector<std::string> lines(card_lines, std::string(100, ' '));
    const auto put = [&](std::string_view name, std::string_view text) {
        for (const InterfaceField& field : interface_fields())
            if (field.name == name) {
                const size_t start = static_cast<size_t>(field.last) - text.size();
                std::copy(text.begin(), text.end(),
                          lines[static_cast<size_t>(field.line) - 1].begin() + static_cast<long>(start));
            }
    };
    put("surf_IDs", "1");
    put("surf_IDm", "2");
    put("IDrby", "1");
    for (const auto& [name, text] : fields)
        put(name, text);
    return fmt::format("/INTER/TYPE21/1\nblank\n{}\n", fmt::join(lines, "\n"));
}

/// The text as a deck of one card.
Deck deck_of_card(const std::string& card_lines_text) {
    Deck deck;
    deck.files = {"blank card"};
    deck.texts = {std::make_shared<const std::string>(card_lines_text)};
    const std::string_view text = *deck.texts.front();
    std::vector<DataLine> lines;
    for (size_t begin = 0; begin < text.size();) {
        const size_t end = text.find('\n', begin);
        lines.push_back({text.substr(begin, end - begin), 0, static_cast<int>(lines.size()) + 1});
        begin = end + 1;
    }
    Card card;
    card.keyword = lines.front().text();
    card.words = {"INTER", "TYPE21", "1"};
    card.place = lines.front();
    card.lines.assign(lines.begin() + 1, lines.end());
    deck.starter.push_back(std::move(card));
    return deck;
}

/// One quad of the blank over one quad of the tool.
Model two_quads() {
    Model model;
    const auto add_quad = [&](double z, double thickness) {
        Shell shell;
        const int first = model.nodes.size();
        for (int j = 0; j < 4; ++j) {
            shell.node[static_cast<size_t>(j)] = first + j;
            model.nodes.id.push_back(first + j + 1);
            model.nodes.index[first + j + 1] = first + j;
            model.nodes.position.push_back({j == 1 || j == 2 ? 1.0 : 0.0, j > 1 ? 1.0 : 0.0, z});
            model.nodes.line.push_back(0);
            model.nodal_mass.push_back(1);
        }
        shell.id = static_cast<Id>(model.shells.size()) + 1;
        shell.part = static_cast<int>(model.shells.size());
        shell.thickness = thickness;
        Surface surface;
        surface.id = shell.id;
        surface.segments.push_back({shell.node, static_cast<int>(model.shells.size())});
        model.surfaces.push_back(surface);
        model.shells.push_back(shell);
        Part part;
        part.id = shell.id;
        part.material = 0;
        part.property = 0;
        model.parts.push_back(part);
    };
    Material steel;
    steel.law = MaterialLaw::elastic;
    steel.young = 2e11;
    steel.density = 7800;
    model.materials.push_back(steel);
    model.properties.emplace_back();
    add_quad(0.0, 1e-3);
    add_quad(-1.0, 1e-3);
    RigidBody body;
    body.id = 1;
    body.main_node = model.nodes.size();
    body.nodes = {4, 5, 6, 7};
    body.mass = 1;
    body.inertia = Mat3::Identity();
    body.center = {0.5, 0.5, -2};
    model.nodes.id.push_back(body.main_node + 1);
    model.nodes.index[body.main_node + 1] = body.main_node;
    model.nodes.position.push_back(body.center);
    model.nodes.line.push_back(0);
    model.nodal_mass.push_back(1);
    model.rigid_bodies.push_back(body);
    return model;
}

}  // namespace

Interface blank_card(const CardFields& fields) {
    const Deck deck = deck_of_card(card_text(fields));
    Model model = two_quads();
    Problems problems;
    resolve_interfaces(deck, model, problems);
    if (problems.has_errors() || model.interfaces.empty())
        throw std::logic_error(fmt::format("the blank card is refused, {} problems", problems.list().size()));
    return model.interfaces.front();
}

}  // namespace type21
