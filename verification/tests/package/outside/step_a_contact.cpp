// One node above one quad, filled by hand, and one step of both implementations: all that a user's own program needs.
#include <cstdio>
#include <memory>
#include <type21/make_contact.h>

int main() {
    using namespace type21;
    const auto model = std::make_shared<ContactModel>();
    model->nodes.id = {1, 2, 3, 4, 5};  // the node of the blank, then the corners of the tool [mm]
    model->nodes.position = {{0.6, 0.2, 0.375}, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    model->surfaces.resize(2);
    model->surfaces[1].segments = {{{1, 2, 3, 4}}};
    model->rigid_bodies.resize(1);
    Interface card;
    card.secondary_surface = 0;
    card.main_surface = 1;
    card.tool = 0;
    card.main_nodes = {1, 2, 3, 4};
    card.istf.value = 1;
    card.stfac.value = 100;  // stiffness [N/mm]
    card.depth.value = 1;
    card.largest_gap = 0.5;
    card.secondary = {{0}, {1.0}, {0}, {0.5}, {0.5}, {1.0}, {0}, {0.001}};  // node, t0, t_c, g0, search gap, A, S, m
    model->interfaces = {card};
    const Scene scene = scene_of(model);

    const std::vector<Vec3> velocity(5, Vec3::Zero());
    Motion motion;
    motion.position = model->nodes.position;
    motion.velocity = velocity;
    motion.tools.resize(1);
    const auto step = [&](const char* name, ContactMethod& contact) {
        const NodeContact node = contact.step(motion).nodes[0];
        std::printf("%s: segment %d, sub-triangle %d, distance %g, penetration %g, force %g %g %g\n", name,
                    node.decision.segment + 1, node.decision.triangle, node.distance, node.penetration, node.force.x(),
                    node.force.y(), node.force.z());
    };
    step("reference", *reference::make_contact(scene, 0));
    step("optimized", *optimized::make_contact(scene, 0));
}
