#include "verification/results/balance/time_zero.h"

#include <algorithm>
#include <numeric>

#include "reference/as_built/reading_of.h"

namespace type21 {
namespace {

Range range(const std::vector<double>& values) {
    if (values.empty()) return {};
    const auto [smallest, largest] = std::minmax_element(values.begin(), values.end());
    return {*smallest, *largest};
}

}  // namespace

TimeZero time_zero(const HostScene& scene, int interface) {
    const Interface& card = scene.model->interfaces.at(static_cast<size_t>(interface));
    const reference::ContactReading reading = reference::as_built::reading_of(*scene.model, card);
    std::vector<double> stiffness;
    for (const double element : card.secondary.element_stiffness)
        stiffness.push_back(reading.nodal_stiffness(card, element));
    TimeZero zero;
    zero.gap = range(card.secondary.gap);
    zero.depth = card.depth;
    zero.stiffness = range(stiffness);
    zero.mass = range(card.secondary.mass);
    zero.total_mass = std::accumulate(card.secondary.mass.begin(), card.secondary.mass.end(), 0.0);
    zero.penetrations = reference::Contact(scene, interface).initial_penetrations();
    std::stable_sort(
        zero.penetrations.begin(), zero.penetrations.end(),
        [](const InitialPenetration& a, const InitialPenetration& b) { return a.penetration > b.penetration; });
    return zero;
}

}  // namespace type21
