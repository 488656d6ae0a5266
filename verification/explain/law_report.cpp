#include "verification/explain/law_report.h"

#include <algorithm>

#include <fmt/format.h>

namespace type21 {

namespace {

std::string range(const std::vector<FrictionPoint>& points, double FrictionPoint::*what) {
    const auto [low, high] = std::minmax_element(points.begin(), points.end(),
                                                 [&](const auto& a, const auto& b) { return a.*what < b.*what; });
    return fmt::format("{:.4g} to {:.4g}", (*low).*what, (*high).*what);
}

std::string of_limit(const InterfaceLaws& laws, const UnitSystem& units) {
    const PressureLimit& limit = laws.limit;
    std::string text = fmt::format("Pmax {:g} {} lowers the force in {} of {} node-cycles", laws.pmax,
                                   units.name(dim::pressure), limit.lowered, limit.node_cycles);
    if (limit.plateau > 0)
        text += fmt::format(", on the plateau at penetrations {:.4g} to {:.4g} {}", limit.first, limit.last,
                            units.length_name);
    return text + fmt::format(", largest F / A {:.4g} {}", limit.largest, units.name(dim::pressure));
}

}  // namespace

std::string to_text(const std::vector<InterfaceLaws>& all, const UnitSystem& units) {
    std::string text;
    for (const InterfaceLaws& laws : all) {
        text += fmt::format("interface {}{}: Ifric {}", laws.id, laws.title.empty() ? "" : " '" + laws.title + "'",
                            laws.ifric);
        if (laws.friction.empty())
            text += ", no node slips";
        else
            text += fmt::format(
                ", nodes slip with mu {} at pressures {} {} and speeds {} {}; the laws of the two "
                "implementations differ by {:.2g} of mu",
                range(laws.friction, &FrictionPoint::mu), range(laws.friction, &FrictionPoint::pressure),
                units.name(dim::pressure), range(laws.friction, &FrictionPoint::speed), units.name(dim::velocity),
                largest_difference(laws));
        if (laws.pmax > 0) text += "; " + of_limit(laws, units);
        if (!laws.heat.empty()) text += "; heat flows";
        text += "\n";
    }
    return text;
}

nlohmann::ordered_json to_json(const std::vector<InterfaceLaws>& all, const UnitSystem& units) {
    Json interfaces = Json::array();
    for (const InterfaceLaws& laws : all) {
        Json curves = Json::array(), friction = Json::array(), normal = Json::array(), heat = Json::array();
        for (const FrictionCurve& curve : laws.curves)
            curves.push_back({{"speed", curve.speed}, {"mu", curve.mu}, {"mu_optimized", curve.mu_optimized}});
        for (const FrictionPoint& point : laws.friction)
            friction.push_back({point.pressure, point.speed, point.mu});
        for (const NormalPoint& point : laws.normal)
            normal.push_back({point.penetration, point.pressure});
        for (const HeatPoint& point : laws.heat)
            heat.push_back({point.distance, point.conductance});
        interfaces.push_back({{"id", laws.id},
                              {"title", laws.title},
                              {"ifric", laws.ifric},
                              {"pmax", laws.pmax},
                              {"several_mu", laws.several_mu},
                              {"difference", largest_difference(laws)},
                              {"pressures", laws.pressures},
                              {"curves", curves},
                              {"friction", friction},
                              {"normal", normal},
                              {"limit",
                               {{"node_cycles", laws.limit.node_cycles},
                                {"lowered", laws.limit.lowered},
                                {"plateau", laws.limit.plateau},
                                {"first", laws.limit.first},
                                {"last", laws.limit.last},
                                {"largest", laws.limit.largest}}},
                              {"heat", heat}});
    }
    return {{"units",
             {{"length", units.length_name},
              {"speed", units.name(dim::velocity)},
              {"pressure", units.name(dim::pressure)},
              {"conductance", units.name(dim::conductance)}}},
            {"interfaces", interfaces}};
}

}  // namespace type21
