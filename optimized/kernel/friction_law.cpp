#include "optimized/kernel/friction_law.h"

#include <algorithm>
#include <numbers>

namespace type21::optimized {

namespace {

/// Renard's curve through (0, C1), (C5, C3), (C6, C4) and towards C2: parabola, cubic, hyperbola.
double renard(const std::array<double, 6>& c, double s) {
    const double first = c[0], last = c[1], top = c[2], bottom = c[3], rise = c[4], fall = c[5];
    if (s <= rise) {
        const double x = s / rise;
        return first + (top - first) * x * (2 - x);
    }
    if (s < fall) {
        const double y = (s - rise) / (fall - rise);
        return top + (bottom - top) * y * y * (3 - 2 * y);
    }
    const double past = s - fall;
    return last - 1 / (1 / (last - bottom) + past * past);
}

/// The part of each node: of its first segment. D42: the last of the deck's parts among those of its segments that
/// the pairs name.
std::vector<int> parts_of_nodes(const ContactModel& model, const Interface& interface,
                                const std::vector<FrictionPair>& pairs) {
    const bool last_named = model.as_built.has(Departure::D42);
    std::vector<int> named;
    for (const FrictionPair& pair : pairs)
        named.insert(named.end(), {pair.part_a, pair.part_b});
    std::sort(named.begin(), named.end());
    const auto& nodes = interface.secondary.node;
    std::vector<int> part(nodes.size(), -1);
    for (const Segment& segment : model.surfaces[static_cast<size_t>(interface.secondary_surface)].segments) {
        if (segment.shell < 0) continue;
        const int own = model.shells[static_cast<size_t>(segment.shell)].part;
        if (last_named && !std::binary_search(named.begin(), named.end(), own)) continue;
        for (const int node : segment.node) {
            const auto rank = std::lower_bound(nodes.begin(), nodes.end(), node) - nodes.begin();
            int& kept = part[static_cast<size_t>(rank)];
            if (kept < 0 || (last_named && own > kept)) kept = own;
        }
    }
    return part;
}

}  // namespace

double FrictionLaw::exponential(double c, double x, double s) const {
    return c == 0 && !drops_ ? 0.0 : c * std::exp(x * s);
}

double FrictionLaw::coefficient(const FrictionCoefficients& f, double p, double s, double factor) const {
    const auto& c = f.c;
    // No pressure, no term of it: also where the exponential beside it overflows.
    const auto with_pressure = [&](double term, double power) { return power == 0 && !drops_ ? 0.0 : term * power; };
    double mu = 0;
    switch (ifric_) {
        case 1:
            mu = f.fric + c[0] * p + c[1] * s + c[2] * p * s + c[3] * p * p + (c[4] == 0 ? 0.0 : c[4] * (s * s));
            break;
        case 2:
            mu = f.fric + with_pressure(exponential(c[0], c[1], s), p * p) +
                 with_pressure(exponential(c[2], c[3], s), p) + exponential(c[4], c[5], s);
            break;
        case 3:
            mu = renard(c, s);
            break;
        case 4:
            mu = c[0] + exponential(reversed_ ? c[0] - f.fric : f.fric - c[0], -c[1], s);
            break;
        default:
            return unbounded_ || f.fric * factor > 0 ? f.fric * factor : 0.0;
    }
    constexpr double greatest = std::numeric_limits<double>::max();
    if (drops_) return mu > 1e-30 ? std::min(mu, greatest) : 1e-30;
    return mu < 1e-30 && mu >= -greatest ? 1e-30 : mu;
}

int FrictionLaw::overflowing(const FrictionCoefficients& f, double s) const {
    const auto& c = f.c;
    if (ifric_ == 1) return 4;
    if (ifric_ == 3) return c[4] == 0 ? 4 : 5;
    if (ifric_ != 2) return 1;
    for (const int factor : {0, 2, 4}) {
        const auto i = static_cast<size_t>(factor);
        if (c[i] != 0 && std::exp(c[i + 1] * s) > std::numeric_limits<double>::max()) return factor + 1;
    }
    return 0;
}

FrictionTable::FrictionTable(const ContactModel& model, const Interface& interface) {
    if (interface.friction_model < 0) {
        common_.fric = interface.fric;
        for (size_t i = 0; i < common_.c.size(); ++i)
            common_.c[i] = interface.c[i];
        return;
    }
    const FrictionModel& friction = model.friction_models[static_cast<size_t>(interface.friction_model)];
    common_ = friction.fallback;
    pairs_ = friction.pairs;
    if (pairs_.empty()) return;
    secondary_part_ = parts_of_nodes(model, interface, pairs_);
    for (const Segment& segment : model.surfaces[static_cast<size_t>(interface.main_surface)].segments)
        main_part_.push_back(segment.shell < 0 ? -1 : model.shells[static_cast<size_t>(segment.shell)].part);
}

const FrictionCoefficients& FrictionTable::at(int node, int segment) const {
    if (!by_parts()) return common_;
    const int one = secondary_part_[static_cast<size_t>(node)], other = main_part_[static_cast<size_t>(segment)];
    for (const FrictionPair& pair : pairs_) {
        if ((pair.part_a == one && pair.part_b == other) || (pair.part_a == other && pair.part_b == one))
            return pair.coefficients;
    }
    return common_;
}

double filter_share(const Interface& interface, double step, const AsBuilt& as_built) {
    const bool of_card = interface.friction_model >= 0 && as_built.has(Departure::D28);
    const int kind = of_card ? interface.card_ifiltr : int(interface.ifiltr);
    const double frequency = of_card ? interface.card_xfreq : double(interface.xfreq);
    constexpr double turn = 2 * std::numbers::pi;
    double share = 1;
    if (frequency != 0 && kind == 1) share = frequency;
    if (frequency != 0 && kind == 2) share = as_built.has(Departure::D07) ? turn / frequency : turn * frequency;
    if (frequency != 0 && kind == 3) share = turn * frequency;
    if (interface.ifiltr != 3) return std::min(share, 1.0);
    return as_built.has(Departure::D06) ? std::max(share * step, 1.0) : std::min(share * step, 1.0);
}

}  // namespace type21::optimized
