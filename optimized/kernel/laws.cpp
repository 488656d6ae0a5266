#include <algorithm>
#include <cmath>

#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

Laws::Laws(const Scene& scene, int interface)
    : model(scene.model),
      card(&model->interfaces[static_cast<size_t>(interface)]),
      tool(*model, *card),
      friction_law(card->ifric, model->as_built),
      friction_table(*model, *card) {
    const auto has_effect = [&](Effect e) { return scene.has(interface, e); };
    rules.proximity_competes = d11 = as_built(Departure::D11);
    rules.lift_leaning = as_built(Departure::D35);
    d05 = as_built(Departure::D05) && card->istf == 1 && card->igap != 2;
    d08 = as_built(Departure::D08);
    d12 = as_built(Departure::D12);
    d16 = as_built(Departure::D16);
    d33 = as_built(Departure::D33);
    // How far heat reaches beyond the gap; D11: Drad counts even where nothing radiates.
    if (card->ithe != 0) {
        if (card->frad > 0 || d11) proximity = card->drad;
        if (card->function_distance >= 0) proximity = std::max(proximity, double(card->dcond));
    }
    if (has_effect(Effect::heat)) heat.emplace(*model, *card);
    if (has_effect(Effect::gap_growth)) growth.emplace(*model, *card);
    if (has_effect(Effect::deletion)) deletion.emplace(*model, card->secondary.node, false);
    if (has_effect(Effect::friction_heat_factor))
        friction_of_temperature = &model->functions[static_cast<size_t>(card->function_friction)];
    coulomb = card->ifric == 0 && card->friction_model < 0 && friction_of_temperature == nullptr;
    skid = has_effect(Effect::skid_line);
    release = has_effect(Effect::release_bcs);
    normals_test = has_effect(Effect::normals_test);
    effects_ = (has_effect(Effect::damping) ? effect::damping : 0) |
               (has_effect(Effect::friction) ? effect::friction : 0) |
               (has_effect(Effect::pmax_limit) ? effect::pmax : 0) | (heat ? effect::heat : 0);
    const bool by_temperature = friction_of_temperature != nullptr;
    if (!coulomb && !by_temperature && has_effect(Effect::friction)) effects_ |= effect::law;
    if (skid || release || normals_test) effects_ |= effect::lists;
    if (by_temperature || deletion || d05 || d11 || d12 || d33) effects_ |= effect::rare | effect::any;
    const auto vector = [&](Term first) {
        for (int i = 0; i < 3; ++i)
            terms_.push_back(static_cast<Term>(static_cast<int>(first) + i));
    };
    vector(Term::normal_x);
    vector(Term::abs_normal_x);
    vector(Term::moment_x);
    for (const Term t :
         {Term::signed_normal, Term::norm_total, Term::elastic_energy, Term::step_stiffness, Term::step_rotation})
        terms_.push_back(t);
    if (has(effect::damping)) terms_.push_back(Term::damping_work);
    if (has(effect::friction)) {
        vector(Term::tangential_x);
        vector(Term::abs_total_x);
        vector(Term::force_x);
        terms_.push_back(Term::friction_work);
    }
    if (has_effect(Effect::tool_damping)) {
        terms_.push_back(Term::stiffness);
        terms_.push_back(Term::rotation);
    }
}

/// @manual eq 9; field Ifric
double Laws::friction_coefficient(int rank, int segment, double normal_force, double speed, double factor,
                                  ChunkLists& lists) const {
    const double area = card->secondary.area[static_cast<size_t>(rank)];
    const double pressure = area > 0 ? normal_force / area : 0.0;
    const FrictionCoefficients& numbers = friction_table.at(rank, segment);
    const double mu = friction_law.coefficient(numbers, pressure, speed, factor);
    if (std::isfinite(mu) || !std::isfinite(pressure) || !std::isfinite(speed)) [[likely]]
        return mu;
    if (++lists.overflow.count == 1) {
        const int culprit = friction_law.overflowing(numbers, speed);
        lists.overflow = {1,       card->secondary.node[static_cast<size_t>(rank)],
                          culprit, numbers.c.at(static_cast<size_t>(culprit)),
                          speed,   pressure};
    }
    return mu;
}

Workspace::Workspace() : batch(std::make_unique<Search::Batch>()), forces(std::make_unique<ForceRows>()) {}
Workspace::Workspace(Workspace&&) noexcept = default;
Workspace::~Workspace() = default;

Cycle::Cycle(const Laws& laws, const Motion& motion_, int inacti_)
    : motion(motion_),
      pose(motion_.tools[static_cast<size_t>(laws.card->tool)]),
      time_zero(motion_.time <= 0),
      inacti(inacti_) {
    if (laws.has(effect::friction)) filter = filter_share(*laws.card, motion_.friction_step, laws.model->as_built);
}

}  // namespace type21::optimized
