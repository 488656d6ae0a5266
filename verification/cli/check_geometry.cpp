#include "verification/cli/check_output.h"

namespace type21::cli {
namespace {

using Json = nlohmann::ordered_json;

Json segments_json(const Model& model, int surface) {
    Json out = Json::array();
    for (const Segment& segment : model.surfaces.at(static_cast<size_t>(surface)).segments) {
        Json corners = Json::array();
        for (int i = 0; i < segment.corners(); ++i)
            corners.push_back(model.nodes.id[static_cast<size_t>(segment.node[static_cast<size_t>(i)])]);
        out.push_back(std::move(corners));
    }
    return out;
}

}  // namespace

Json geometry_json(const HostScene& scene) {
    const Model& model = *scene.host;
    Json nodes = Json::array();
    for (size_t i = 0; i < model.nodes.id.size(); ++i) {
        const Vec3& x = model.nodes.position[i];
        nodes.push_back({model.nodes.id[i], x[0], x[1], x[2]});
    }
    Json interfaces = Json::array();
    for (const Interface& interface : model.interfaces)
        interfaces.push_back({{"id", interface.id},
                              {"secondary", segments_json(model, interface.secondary_surface)},
                              {"main", segments_json(model, interface.main_surface)}});
    return {{"nodes", std::move(nodes)}, {"interfaces", std::move(interfaces)}};
}

}  // namespace type21::cli
