/// @file Normal force, friction and the force on the node: chapters 7 and 8 of the formulation.
#include <cmath>

#include <fmt/format.h>

#include "reference/contact/friction_law.h"
#include "verification/explain/node_account.h"

namespace type21 {

using namespace reference;

namespace {

/// The formula of the friction law, and the same with numbers; the pressure p and the speed s are on the lines above.
struct Law {
    std::string formula, numbers;
};

Law law_of(int ifric, const FrictionCoefficients& f, double s) {
    const auto& c = f.c;
    switch (ifric) {
        case 1:
            return {"Fric + C1 p + C2 s + C3 p s + C4 p^2 + C5 s^2",
                    fmt::format("{:.6g} + {:.6g} p + {:.6g} s + {:.6g} p s + {:.6g} p^2 + {:.6g} s^2", f.fric, c[0],
                                c[1], c[2], c[3], c[4])};
        case 2:
            return {"Fric + C1 e^(C2 s) p^2 + C3 e^(C4 s) p + C5 e^(C6 s)",
                    fmt::format("{:.6g} + {:.6g} e^({:.6g} s) p^2 + {:.6g} e^({:.6g} s) p + {:.6g} e^({:.6g} s)",
                                f.fric, c[0], c[1], c[2], c[3], c[4], c[5])};
        case 3:
            if (s <= c[4])
                return {"s <= C5: C1 + (C3 - C1) x (2 - x), x = s/C5",
                        fmt::format("{:.6g} + {:.6g} x (2 - x), x = {:.6g}", c[0], c[2] - c[0], s / c[4])};
            if (s < c[5])
                return {"C5 < s < C6: C3 + (C4 - C3) y^2 (3 - 2 y), y = (s - C5)/(C6 - C5)",
                        fmt::format("{:.6g} + {:.6g} y^2 (3 - 2 y), y = {:.6g}", c[2], c[3] - c[2],
                                    (s - c[4]) / (c[5] - c[4]))};
            return {"s >= C6: C2 - 1/(1/(C2 - C4) + (s - C6)^2)",
                    fmt::format("{:.6g} - 1/(1/{:.6g} + {:.6g}^2)", c[1], c[1] - c[3], s - c[5])};
        case 4:
            return {"C1 + (Fric - C1) e^(-C2 s)",
                    fmt::format("{:.6g} + {:.6g} e^({:.6g} s)", c[0], f.fric - c[0], -c[1])};
        default:
            return {"Fric", ""};
    }
}

std::string law_source(int ifric) {
    constexpr const char* sources[] = {"Ifric 0, manual page, comment 12", "Ifric 1, manual page, equation (10)",
                                       "Ifric 2, manual page, equation (11)", "Ifric 3, manual page, comment 13",
                                       "Ifric 4, Formulation 8, step 7"};
    return sources[ifric];
}

void add_law(const AccountInput& input, const Replay& replay, AccountSection& section) {
    const Interface& card = input.card();
    const Vec3& v = replay.input.velocity;
    const double speed = (v - replay.input.normal * v.dot(replay.input.normal)).norm();
    if (card.ifric != 0) {
        const double area = card.secondary.area[static_cast<size_t>(input.node)];
        section.add("p", "F_n/A, pressure", fmt::format("{}/{}", digits(replay.normal_force), digits(area)),
                    area > 0 ? replay.normal_force / area : 0.0, input.unit(dim::pressure),
                    "manual page, equation (9)");
        section.add("s", "|v - v_n nu|, speed", "", speed, input.unit(dim::velocity), "manual page, equation (9)");
    }
    const FrictionCoefficients numbers = input.inspect.friction_numbers(input.node, replay.input);
    if (input.inspect.has(Effect::friction_heat_factor)) {
        const bool d39 = input.model().as_built.has(Departure::D39);
        section.add("mu", d39 ? "Fric f_IDF(AscaleF (T_s + T_m)/2)" : "max(0, Fric f_IDF(AscaleF (T_s + T_m)/2))",
                    fmt::format("{} x {}", digits(numbers.fric), digits(replay.input.temperature_factor)),
                    replay.coefficient, "", "manual page, equations (7), (8)");
        return;
    }
    const Law law = law_of(card.ifric, numbers, speed);
    section.add("mu", law.formula, law.numbers, replay.coefficient, "",
                card.friction_model >= 0 ? law_source(card.ifric) + ", /FRICTION" : law_source(card.ifric));
    if (card.ifric == 4 && input.model().as_built.has(Departure::D10))
        section.say("", "with the sign of the second term reversed", "D10");
}

}  // namespace

AccountSection normal_section(const AccountInput& input, const NodeContact& node, const Replay& replay) {
    const Interface& card = input.card();
    const std::string force = input.unit(dim::force);
    const std::string stiffness = input.unit(dim::stiffness);
    const auto n = static_cast<size_t>(input.node);
    AccountSection section{"normal force", {}};
    if (card.istf == 1) {
        section.add("k", replay.acts ? "Stfac" : "0, p = 0", "", node.stiffness, stiffness,
                    "Istf 1, Formulation 7, step 1");
    } else {
        const double element = card.secondary.element_stiffness[n];
        const bool bounded = replay.acts && node.stiffness != card.stfac * element;
        section.add("k",
                    !replay.acts ? "0, p = 0"
                    : bounded    ? "Stfac S, between Stmin and Stmax"
                                 : "Stfac S",
                    replay.acts ? fmt::format("{} x {}", digits(card.stfac), digits(element)) : "", node.stiffness,
                    stiffness, "Formulation 7, step 1");
    }
    const std::string product = fmt::format("{} x {}", digits(node.stiffness), digits(node.penetration));
    if (input.inspect.has(Effect::pmax_limit)) {
        const double limit = replay.pmax.pressure_force;
        section.add("Delta", "max(g - g0, 0)",
                    fmt::format("max({} - {}, 0)", digits(node.gap), digits(card.secondary.gap[n])),
                    replay.pmax.gap_growth, input.unit(dim::length), "Formulation 7, step 3");
        section.add("P_A", "A Pmax", fmt::format("{} x {}", digits(card.secondary.area[n]), digits(card.pmax)), limit,
                    force, "manual page, comment 5");
        section.add("k Delta", replay.limited ? "> P_A: plateau" : "<= P_A: no plateau", "",
                    node.stiffness * replay.pmax.gap_growth, force, "manual page, equation (5)");
    }
    if (replay.limited) {
        section.add("F", "k max(p - Delta, 0) + min(P_A, k p)",
                    fmt::format("{0:.6g} x max({1:.6g} - {2:.6g}, 0) + min({3:.6g}, {0:.6g} x {1:.6g})", node.stiffness,
                                node.penetration, replay.pmax.gap_growth, replay.pmax.pressure_force),
                    node.elastic_force, force, "manual page, equation (5)");
    } else {
        section.add("F", "k p", product, node.elastic_force, force,
                    card.igap == 2 ? "manual page, equation (5)" : "Formulation 7, step 2");
    }
    section.add("v", "v_node - (V_t + Omega x (X - x_G))", "", node.relative_velocity, input.unit(dim::velocity),
                "Formulation 7, step 5");
    section.add("v_n", "<v, nu>", "", replay.normal_velocity, input.unit(dim::velocity), "Formulation 7, step 5");
    if (input.inspect.has(Effect::damping))
        section.add("C", "VISs sqrt(2 k m)",
                    fmt::format("{} sqrt(2 x {} x {})", digits(card.viss), digits(node.stiffness),
                                digits(input.inspect.mass(input.node))),
                    node.damping, input.unit({1, 0, -1, 0}), "Formulation 7, step 6");
    section.add(
        "F_n", "F - C v_n",
        fmt::format("{} - {} x {}", digits(node.elastic_force), digits(node.damping), digits(replay.normal_velocity)),
        node.normal_force, force, "Formulation 7, step 7");
    if (node.normal_force < 0) section.say("", "F_n < 0: the damper pulls; kept, as measured", "Formulation 7, step 6");
    return section;
}

AccountSection friction_section(const AccountInput& input, const NodeContact& node, const Replay& replay) {
    const std::string force = input.unit(dim::force);
    AccountSection section{"friction", {}};
    if (!replay.has_friction) {
        section.say("", "no friction on this interface (Fric 0)", "manual page, comment 12");
        return section;
    }
    add_law(input, replay, section);
    section.add("mu|F_n|", "", fmt::format("{} x {}", digits(replay.coefficient), digits(std::abs(node.normal_force))),
                replay.coefficient * std::abs(node.normal_force), force, "manual page, comment 14");
    if (std::isfinite(replay.input.cap))
        section.add("cap", "A Pmax/sqrt(3)", "", replay.input.cap, force, "ITlim 0, manual page, equation (6)");
    if (input.inspect.has(Effect::friction_filter))
        section.add("alpha", fmt::format("Ifiltr {}", input.card().ifiltr.value), "", replay.filter, "",
                    "manual page, comment 15");
    section.add("F_t old", "", "", input.before.friction, force, "from the cycle before");
    const bool filtered = replay.filter != 1;
    const double increment = replay.filter * replay.input.stiffness * replay.input.step;
    section.add(filtered ? "alpha k dt" : "k dt", "",
                fmt::format("{}{} x {}", filtered ? digits(replay.filter) + " x " : "", digits(replay.input.stiffness),
                            digits(replay.input.step)),
                increment, input.unit({1, 0, -1, 0}), "Formulation 8, step 9");
    section.add(
        "T",
        filtered ? "F_t old + alpha k dt v, without its part along nu" : "F_t old + k dt v, without its part along nu",
        "", replay.friction.trial, force, filtered ? "manual page, equation (13)" : "manual page, equation (12)");
    section.add("|T|",
                fmt::format("{} limit {}: {}", replay.friction.slips ? ">" : "<=", digits(replay.limit),
                            replay.friction.slips ? "slips" : "sticks"),
                "", replay.friction.trial.norm(), force, "Formulation 8, step 10");
    section.add("F_t", replay.friction.slips ? "T limit/|T|" : "T", "", node.friction, force,
                std::isfinite(replay.input.cap) ? "manual page, equation (6)" : "Formulation 8, step 10");
    section.add("q", "<T - F_t, F_t>/k", "", replay.slip_energy, input.unit(dim::energy),
                "slip energy, manual page, equation (19)");
    if (input.inspect.has(Effect::skid_line))
        section.add("skid", "min(1, |F_t| sqrt(3)/(Pskid A)), sliding", "",
                    input.step.skid[static_cast<size_t>(input.node)], "", "Formulation 9, step 14");
    return section;
}

AccountSection force_section(const AccountInput& input, const NodeAccount& account) {
    const NodeContact& node = account.node;
    AccountSection section{"on the node", {}};
    section.add("F", "F_n nu - F_t", "", node.force, input.unit(dim::force), "Formulation 8, step 10");
    if (account.replay.impact)
        section.add("k_step", input.motion.step > 0 ? "k + C/dt" : "k, dt = 0", "", node.step_stiffness,
                    input.unit(dim::stiffness), "Formulation 7, step 7");
    section.say("check",
                account.agrees
                    ? "evaluated again from these formulas, the force is that of the run, in every bit"
                    : "evaluated again from these formulas, the force is NOT that of the run: please report this");
    return section;
}

}  // namespace type21
