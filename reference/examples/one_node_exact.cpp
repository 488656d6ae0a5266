// The node and the quad of one_node.cpp, asked of the reference: the same steps, but what is decided is decided
// exactly.
//   usage: one_node_exact [X Y Z]     the node [mm]; default 0.3 0.2 0.1
#include <cstdio>
#include <cstdlib>
#include <memory>
#include <type21/make_contact.h>

using namespace type21;

int main(int count, char** word) {
    const bool given = count == 4;
    const Vec3 p(given ? std::atof(word[1]) : 0.3, given ? std::atof(word[2]) : 0.2, given ? std::atof(word[3]) : 0.1);

    // The scene, filled by hand: node 0 is the blank's, nodes 1 to 4 are the corners of the tool's quad [mm].
    const auto model = std::make_shared<ContactModel>();
    model->nodes.id = {1, 2, 3, 4, 5};
    model->nodes.position = {p, {0, 0, 0}, {1, 0, 0}, {1, 1, 0.25}, {0, 1, 0}};
    model->surfaces.resize(2);
    model->surfaces[1].segments = {{{1, 2, 3, 4}}};
    model->rigid_bodies.resize(1);
    Interface card;
    card.secondary_surface = 0;
    card.main_surface = 1;
    card.tool = 0;
    card.main_nodes = {1, 2, 3, 4};
    card.istf.value = 1;
    card.stfac.value = 100;  // the stiffness itself [N/mm]
    card.depth.value = 1;    // [mm]
    card.largest_gap = 0.5;  // [mm]
    SecondarySide& side = card.secondary;
    side.node = {0};
    side.gap = side.search_gap = {0.5};  // [mm]
    side.thickness = side.contact_thickness = side.element_stiffness = {0};
    side.area = side.mass = {1};
    model->interfaces = {card};

    // One cycle at time 0, with everything at rest.
    const std::vector<Vec3> velocity(5, Vec3::Zero());
    Motion motion;
    motion.position = model->nodes.position;
    motion.velocity = velocity;
    motion.tools.resize(1);
    const auto contact = reference::make_contact(scene_of(model), 0);
    const NodeContact node = contact->step(motion).nodes[0];

    const char* arithmetic[] = {"doubles with a bound on their error", "intervals", "rational numbers"};
    std::printf("decided by %s\n", arithmetic[static_cast<int>(node.decision.stage)]);
    if (node.decision.kind == Kind::none) return std::puts("retained: none, no force"), 0;
    std::printf("retained: sub-triangle %d, distance %.6f, penetration %.6f\n", node.decision.triangle, node.distance,
                node.penetration);
    std::printf("force on the node: %.6f %.6f %.6f\n", node.force.x(), node.force.y(), node.force.z());
}
