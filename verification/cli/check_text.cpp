#include <algorithm>

#include <fmt/format.h>

#include "reference/model/field_table.h"
#include "verification/cli/check_output.h"

namespace type21::cli {
namespace {

constexpr size_t most_penetrations = 20;

/// "1 part", "3 parts"
std::string counted(size_t count, const char* what) {
    return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string scene_text(const Model& model) {
    std::string out = fmt::format("{}\n", model.title.empty() ? model.run_name : model.title);
    const auto units = [](const UnitSystem& u) {
        return fmt::format("{} {} {}", u.mass_name, u.length_name, u.time_name);
    };
    out += fmt::format("units     {} (deck written in {})\n", units(model.units), units(model.input_units));
    out += fmt::format("as built  {}\n", model.as_built.text());
    const auto triangles =
        std::count_if(model.shells.begin(), model.shells.end(), [](const Shell& s) { return s.is_triangle(); });
    out += fmt::format("sizes     {}, {} ({}), {}, {}\n", counted(static_cast<size_t>(model.nodes.size()), "node"),
                       counted(model.shells.size(), "shell"), counted(static_cast<size_t>(triangles), "triangle"),
                       counted(model.parts.size(), "part"), counted(model.interfaces.size(), "interface"));
    for (const Surface& surface : model.surfaces)
        out += fmt::format("surface   {} '{}': {} segments\n", surface.id, surface.title, surface.segments.size());
    for (const RigidBody& body : model.rigid_bodies) {
        const std::string length = model.units.name(dim::length);
        out += fmt::format(
            "body      {} '{}': main node {}, {} nodes, mass {:.6g} {}, centre ({:.6g}, {:.6g}, {:.6g}) {}\n", body.id,
            body.title, model.nodes.id[static_cast<size_t>(body.main_node)], body.nodes.size(), body.mass,
            model.units.name(dim::mass), body.center.x(), body.center.y(), body.center.z(), length);
    }
    return out;
}

std::string fields_text(const Interface& interface, const UnitSystem& units) {
    const std::vector<FieldRow> rows = field_table(interface, units);
    size_t value_width = 5;
    size_t unit_width = 4;
    for (const FieldRow& row : rows) {
        value_width = std::max(value_width, row.value.size());
        unit_width = std::max(unit_width, row.unit.size());
    }
    std::string out = fmt::format("  {:>4}  {:<10}  {:>{}}  {:<{}}  origin\n", "line", "field", "value", value_width,
                                  "unit", unit_width);
    int line = 0;
    for (const FieldRow& row : rows) {
        out += fmt::format("  {:>4}  {:<10}  {:>{}}  {:<{}}  {}\n",
                           row.card_line == line ? "" : fmt::format("{}", row.card_line), row.name, row.value,
                           value_width, row.unit, unit_width, to_text(row.origin));
        line = row.card_line;
    }
    return out;
}

std::string range_text(const Range& range, const std::string& unit) {
    if (range.smallest == range.largest) return fmt::format("{:.9g} {}", range.smallest, unit);
    return fmt::format("{:.9g} to {:.9g} {}", range.smallest, range.largest, unit);
}

std::string time_zero_text(const Model& model, const TimeZero& zero) {
    const UnitSystem& units = model.units;
    const std::string length = units.name(dim::length);
    std::string out = "  at time 0\n";
    out += fmt::format("    gap        {}\n", range_text(zero.gap, length));
    out += fmt::format("    DEPTH      {:.9g} {}\n", zero.depth, length);
    out += fmt::format("    stiffness  {} per node\n", range_text(zero.stiffness, units.name(dim::stiffness)));
    out += fmt::format("    mass       {} per node, {:.9g} {} in all\n", range_text(zero.mass, units.name(dim::mass)),
                       zero.total_mass, units.name(dim::mass));
    if (zero.penetrations.empty()) return out + "    initial penetrations  none\n";
    out += fmt::format("    initial penetrations  {}, deepest first\n", zero.penetrations.size());
    const size_t shown = std::min(zero.penetrations.size(), most_penetrations);
    for (size_t i = 0; i < shown; ++i) {
        const InitialPenetration& p = zero.penetrations[i];
        out += fmt::format("      node {:>10}  segment {:>8}  {:.9g} {}\n", model.nodes.id[static_cast<size_t>(p.node)],
                           p.segment + 1, p.penetration, length);
    }
    if (shown < zero.penetrations.size()) out += fmt::format("      and {} more\n", zero.penetrations.size() - shown);
    return out;
}

}  // namespace

std::string check_text(const HostScene& scene, const std::vector<TimeZero>& zero) {
    const Model& model = *scene.host;
    std::string out = scene_text(model);
    for (size_t i = 0; i < model.interfaces.size(); ++i) {
        const Interface& interface = model.interfaces[i];
        const Surface& secondary = model.surfaces[static_cast<size_t>(interface.secondary_surface)];
        const Surface& main = model.surfaces[static_cast<size_t>(interface.main_surface)];
        out += fmt::format("\n/INTER/TYPE21/{} '{}'\n", interface.id, interface.title);
        out += fmt::format("  secondary  surface {}: {} segments, {} nodes, shortest edge {:.6g} {}\n", secondary.id,
                           secondary.segments.size(), interface.secondary.size(), interface.shortest_edge,
                           model.units.name(dim::length));
        out += fmt::format("  main       surface {}: {} segments, {} nodes, of rigid body {}\n", main.id,
                           main.segments.size(), interface.main_nodes.size(),
                           model.rigid_bodies[static_cast<size_t>(interface.tool)].id);
        std::string effects;
        for (const Effect effect : scene.effects[i])
            effects += fmt::format("{}{}", effects.empty() ? "" : ", ", name(effect));
        out += fmt::format("  effects    {}\n", effects);
        out += fields_text(interface, model.units) + time_zero_text(model, zero[i]);
    }
    return out;
}

}  // namespace type21::cli
