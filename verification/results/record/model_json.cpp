#include <fmt/format.h>

#include "reference/model/field_table.h"
#include "verification/results/record/run_summary.h"

namespace type21 {
namespace {

using Json = nlohmann::ordered_json;

Json units_json(const UnitSystem& units) {
    return {{"mass", units.mass_name}, {"length", units.length_name}, {"time", units.time_name}};
}

Json surface_json(const Surface& surface) {
    size_t triangles = 0;
    for (const Segment& segment : surface.segments)
        triangles += segment.is_triangle() ? 1 : 0;
    return {{"id", surface.id},
            {"title", surface.title},
            {"segments", surface.segments.size()},
            {"quads", surface.segments.size() - triangles},
            {"triangles", triangles}};
}

Json interface_json(const HostScene& scene, size_t index) {
    const Model& model = *scene.host;
    const Interface& interface = model.interfaces[index];
    Json parameters = Json::array();
    for (const FieldRow& row : field_table(interface, model.units))
        parameters.push_back({{"card_line", row.card_line},
                              {"name", row.name},
                              {"value", row.value},
                              {"unit", row.unit},
                              {"origin", to_text(row.origin)}});
    Json effects = Json::array();
    for (const Effect effect : scene.effects.at(index))
        effects.push_back(name(effect));
    Json json = {{"id", interface.id}, {"title", interface.title}, {"effects", effects}};
    if (interface.tool >= 0) {
        const RigidBody& tool = model.rigid_bodies[static_cast<size_t>(interface.tool)];
        json["tool"] = {{"id", tool.id}, {"title", tool.title}, {"mass", tool.mass}};
    }
    json["secondary"] = surface_json(model.surfaces.at(static_cast<size_t>(interface.secondary_surface)));
    json["secondary"]["nodes"] = interface.secondary.size();
    json["main"] = surface_json(model.surfaces.at(static_cast<size_t>(interface.main_surface)));
    json["main"]["nodes"] = interface.main_nodes.size();
    json["parameters"] = std::move(parameters);
    return json;
}

}  // namespace

Json model_json(const HostScene& scene) {
    const Model& model = *scene.host;
    Json interfaces = Json::array();
    for (size_t i = 0; i < model.interfaces.size(); ++i)
        interfaces.push_back(interface_json(scene, i));
    return {{"deck", model.deck_path},
            {"run_name", model.run_name},
            {"title", model.title},
            {"as_built", model.as_built.text()},
            {"units", units_json(model.units)},
            {"input_units", units_json(model.input_units)},
            {"end_time", model.engine.end_time},
            {"interfaces", std::move(interfaces)}};
}

}  // namespace type21
