// Friction, its laws and its filter, skid line.
#include <algorithm>

#include <fmt/format.h>

#include "verification/criteria/mutation/break_contact.h"

namespace type21 {

namespace {

/// Coefficients of the card and of /FRICTION.
void change_coefficients(ContactModel& model, Interface& card,
                         const std::function<void(FrictionCoefficients&)>& change) {
    FrictionCoefficients own;
    own.fric = card.fric;
    for (size_t i = 0; i < 6; ++i)
        own.c[i] = card.c[i];
    change(own);
    card.fric.value = own.fric;
    for (size_t i = 0; i < 6; ++i)
        card.c[i].value = own.c[i];
    for (FrictionModel& table : model.friction_models) {
        change(table.fallback);
        for (FrictionPair& pair : table.pairs)
            change(pair.coefficients);
    }
}

BreakContact coefficients(std::function<void(FrictionCoefficients&)> change) {
    return broken_card([=](ContactModel& model, Interface& card) { change_coefficients(model, card, change); });
}

/// Loses the envelope: only a cycle that raises it reports a value.
BreakStep forget_envelope(const Scene&, int) {
    return [before = std::vector<double>()](ContactStep& step, const Motion&) mutable {
        before.resize(step.skid.size(), 0.0);
        for (size_t i = 0; i < step.skid.size(); ++i) {
            const double envelope = step.skid[i];
            if (!(envelope > before[i])) step.skid[i] = 0;
            before[i] = envelope;
        }
    };
}

std::function<bool(const HostScene&, int)> law(int ifric) {
    return [=](const Scene& s, int i) {
        return s.has(i, Effect::friction) && s.model->interfaces[static_cast<size_t>(i)].ifric == ifric;
    };
}

std::function<bool(const HostScene&, int)> filter(int ifiltr) {
    return [=](const Scene& s, int i) {
        return s.has(i, Effect::friction_filter) && s.model->interfaces[static_cast<size_t>(i)].ifiltr == ifiltr;
    };
}

}  // namespace

std::vector<Mutation> friction_mutations() {
    using enum Effect;
    const auto has_friction = has_effect(friction);
    std::vector<Mutation> all{
        {"friction_off", "friction", "mu = 0", has_friction, without_effect(friction), {}},
        {"fric_millionth",
         "mu",
         "Fric and the law's coefficients are larger by a millionth",
         has_friction,
         coefficients([](FrictionCoefficients& f) {
             f.fric *= 1 + 1e-6;
             for (double& c : f.c)
                 c *= 1 + 1e-6;
         }),
         {}},
        {"friction_reversed",
         "friction force, F_t",
         "F_t drives the sliding",
         has_friction,
         broken_nodes([](NodeContact& n) {
             n.friction = -n.friction;
             n.force = n.normal_force * n.normal - n.friction;
         }),
         {}},
        {"friction_forgotten",
         "friction increment",
         "the friction force of the last cycle is lost",
         has_friction,
         forgetful(),
         {}},
        {"cone_of_components",
         "Coulomb's cone",
         "each component of F_t is limited separately",
         has_friction,
         broken_nodes([](NodeContact& n) {
             if (n.status != Status::slip) return;
             const double most = n.friction.cwiseAbs().maxCoeff();
             if (most > 0) n.friction *= n.friction.norm() / most;
             n.force = n.normal_force * n.normal - n.friction;
         }),
         {}},
        {"friction_step_off",
         "friction increment, alpha k v dt",
         "the increment has half the step",
         has_friction,
         broken_motion([](Motion& m, const Interface&) { m.friction_step *= 0.5; }),
         {}},
        {"pairs_ignored",
         "/FRICTION",
         "all pairs of parts have the default coefficients",
         has_card([](const Interface& c) { return c.friction_model >= 0; }),
         broken_card([](ContactModel& m, Interface&) {
             for (FrictionModel& table : m.friction_models)
                 table.pairs.clear();
         }),
         {}},
        {"temperature_factor_off",
         "fct_IDF",
         "mu does not depend on temperature",
         has_effect(friction_heat_factor),
         without_effect(friction_heat_factor),
         {}},
        {"ascalef_ignored",
         "AscaleF",
         "the abscissa is not scaled",
         [](const Scene& s, int i) {
             return s.has(i, friction_heat_factor) && s.model->interfaces[static_cast<size_t>(i)].ascalef != 1.0;
         },
         broken_card([](ContactModel&, Interface& c) { c.ascalef.value = 1; }),
         {}},
        {"skid_off", "Pskid", "no skid line", has_effect(skid_line), without_effect(skid_line), {}},
        {"skid_envelope_forgotten",
         "Pskid",
         "the largest ratio so far is not kept",
         has_effect(skid_line),
         broken_step(forget_envelope),
         {}},
    };
    const char* laws[] = {"", "viscous law", "Darmstadt law", "Renard law", "exponential decay"};
    for (int k = 1; k <= 4; ++k) {
        all.push_back({fmt::format("law_{}_as_coulomb", k),
                       fmt::format("Ifric {}, {}", k, laws[k]),
                       "mu = Fric for every pressure and velocity",
                       law(k),
                       broken_card([](ContactModel& m, Interface& c) {
                           c.ifric.value = 0;
                           for (FrictionModel& table : m.friction_models)
                               table.ifric = 0;
                       }),
                       {}});
        // Laws 1 and 2 depend on the pressure, laws 3 and 4 on the speed alone.
        const bool by_pressure = k <= 2;
        all.push_back(
            {fmt::format("law_{}_{}", k, by_pressure ? "half_pressure" : "c2_thousandth"),
             fmt::format("Ifric {}, {}", k, laws[k]),
             by_pressure ? "the node's area is doubled, so its pressure is half" : "C2 is larger by a thousandth",
             law(k),
             broken_card([by_pressure](ContactModel& m, Interface& c) {
                 if (by_pressure)
                     for (double& area : c.secondary.area)
                         area *= 2;
                 else
                     change_coefficients(m, c, [](FrictionCoefficients& f) { f.c[1] *= 1.001; });
             }),
             {}});
    }
    for (int k = 1; k <= 3; ++k)
        all.push_back({fmt::format("filter_{}_off", k),
                       fmt::format("Ifiltr {}, Xfreq", k),
                       "F_t is not filtered: alpha = 1",
                       filter(k),
                       broken_card([](ContactModel& m, Interface& c) {
                           c.ifiltr.value = c.card_ifiltr = 0;
                           for (FrictionModel& table : m.friction_models)
                               table.ifiltr = 0;
                       }),
                       {}});
    return all;
}

}  // namespace type21
