#include "verification/results/balance/time_zero.h"

#include <algorithm>
#include <memory>
#include <numeric>

#include "reference/as_built/reading_of.h"
#include "verification/support/contact_choice.h"

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
    // The optimized contact decides as the reference does, and a blank of a million nodes does not make anyone wait.
    const std::unique_ptr<ContactMethod> contact = contact_maker("optimized")(scene, interface);
    zero.penetrations = contact->initial_penetrations(scene.model->nodes.position);
    std::stable_sort(
        zero.penetrations.begin(), zero.penetrations.end(),
        [](const InitialPenetration& a, const InitialPenetration& b) { return a.penetration > b.penetration; });
    return zero;
}

}  // namespace type21
