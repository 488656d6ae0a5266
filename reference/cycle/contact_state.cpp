#include "reference/cycle/contact_state.h"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "reference/as_built/reading_of.h"

namespace type21::reference {

namespace {

std::shared_ptr<const ContactModel> checked(const Scene& scene, int interface) {
    const size_t count = scene.model->interfaces.size();
    if (interface < 0 || static_cast<size_t>(interface) >= count) {
        throw std::out_of_range("there is no interface " + std::to_string(interface) + ": the model has " +
                                std::to_string(count) + ", counted from 0");
    }
    return scene.model;
}

std::vector<NodeConstants> node_constants(const Interface& card, const ContactReading& reading) {
    const SecondarySide& side = card.secondary;
    std::vector<NodeConstants> nodes(static_cast<size_t>(side.size()));
    for (size_t i = 0; i < nodes.size(); ++i) {
        nodes[i].gap = side.gap[i];
        nodes[i].search_gap = side.search_gap[i];
        nodes[i].stiffness = reading.nodal_stiffness(card, side.element_stiffness[i]);
        nodes[i].friction_stiffness = reading.friction_stiffness(card, nodes[i].stiffness, side.element_stiffness[i]);
        nodes[i].mass = side.mass[i];
    }
    return nodes;
}

double farthest_reach(const Interface& card, double proximity) {
    double reach = std::max<double>(card.depth, proximity);
    for (const double gap : card.secondary.search_gap)
        reach = std::max(reach, gap);
    return reach;
}

}  // namespace

Contact::State::State(const Scene& scene_, int interface_)
    : scene(scene_),
      model(checked(scene_, interface_)),
      interface(interface_),
      reading(as_built::reading_of(*model, card())),
      nodes(node_constants(card(), reading)),
      surface(*model, card()),
      proximity(reading.heat_reach(card())),
      reach(farthest_reach(card(), proximity)),
      candidates(surface, reach),
      inacti(card().inacti),
      offsets(nodes.size()) {
    if (has(Effect::gap_growth)) gap_growth.emplace(*model, card());
    if (has(Effect::friction)) friction.emplace(*model, card(), reading);
    if (has(Effect::skid_line)) skid_line.emplace(card().secondary.size());
    if (has(Effect::deletion)) deletion.emplace(*model, card());
    if (has(Effect::heat)) heat_exchange.emplace(*model, card(), reading);
    if (has(Effect::release_bcs)) release.emplace(card().secondary.size());
    if (has(Effect::adaptive_data)) adaptive.emplace(*model, card(), surface, reading.division_radius_factor);
}

void Contact::State::start(const Motion& motion) {
    started = true;
    if (motion.time > 0 || (inacti != 1 && inacti != 5 && inacti != 6)) return;
    bool any_penetrates = false;
    for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
        const auto n = static_cast<size_t>(i);
        const Vec3& position = motion.position[model_node(i)];
        const double penetration = locate(i, position, pose(motion), reading.first_impact).penetration;
        if (penetration <= 0) continue;
        any_penetrates = true;
        offsets[n].offset = initial_offset(inacti, penetration, nodes[n].gap, card().depth);
        if (inacti == 1) nodes[n].stiffness = nodes[n].friction_stiffness = 0;
    }
    inacti = reading.inacti_of_later_impacts(inacti, any_penetrates);
}

void Contact::State::update_gaps(const Motion& motion, ContactStep& step) {
    step.smallest_gap_raw = card().smallest_gap_raw;
    step.largest_gap_raw = card().largest_gap;
    if (!gap_growth) return;
    step.smallest_gap_raw = 1e30;
    step.largest_gap_raw = 0;
    double largest = 0;
    for (size_t i = 0; i < nodes.size(); ++i) {
        const SheetThickness sheet = gap_growth->sheet(static_cast<int>(i), motion.thickness);
        const NodalGap gap = reading.grown_gap(card(), sheet);
        nodes[i].gap = gap.clipped;
        nodes[i].search_gap = reading.search_gap(card(), gap);
        largest = std::max(largest, nodes[i].search_gap);
        step.smallest_gap_raw = std::min(step.smallest_gap_raw, gap.raw);
        step.largest_gap_raw = std::max(step.largest_gap_raw, gap.raw);
    }
    if (largest <= reach) return;
    reach = 1.5 * largest;  // half as much again, so that a growing sheet does not rebuild them every cycle
    candidates = Candidates(surface, reach);
}

void Contact::State::restore_reach() {
    if (reach > farthest_reach(card(), proximity)) candidates = Candidates(surface, reach);
}

int Contact::State::part_of_segment(int segment) const {
    const Segment& main =
        model->surfaces[static_cast<size_t>(card().main_surface)].segments[static_cast<size_t>(segment)];
    return main.shell < 0 ? -1 : model->shells[static_cast<size_t>(main.shell)].part;
}

}  // namespace type21::reference
