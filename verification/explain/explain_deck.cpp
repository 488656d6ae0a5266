#include "verification/explain/explain_deck.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>

namespace type21 {

using namespace reference;

namespace {

/// A secondary node in one interface.
struct Seat {
    int interface = 0;
    int rank = 0;
};

struct Found {};  ///< ends the march at the cycle that was asked for

std::string interface_ids(const Model& model) {
    std::string out;
    for (const Interface& it : model.interfaces)
        out += fmt::format("{}{}", out.empty() ? "" : ", ", it.id);
    return out;
}

/// "1001 to 1045, 45 nodes"
std::string secondary_ids(const Model& model, const Interface& it) {
    const auto& nodes = it.secondary.node;
    if (nodes.empty()) return "no nodes";
    return fmt::format("{} to {}, {} nodes", model.nodes.id[static_cast<size_t>(nodes.front())],
                       model.nodes.id[static_cast<size_t>(nodes.back())], nodes.size());
}

std::vector<Seat> places_of(const Model& model, const ExplainRequest& request) {
    const auto found = model.nodes.index.find(request.node);
    if (found == model.nodes.index.end()) throw ExplainError(fmt::format("the deck has no node {}", request.node));
    std::vector<Seat> places;
    std::string looked_at;
    for (size_t i = 0; i < model.interfaces.size(); ++i) {
        const Interface& it = model.interfaces[i];
        if (request.interface && it.id != *request.interface) continue;
        looked_at +=
            fmt::format("{}interface {} has {}", looked_at.empty() ? "" : "; ", it.id, secondary_ids(model, it));
        const auto& nodes = it.secondary.node;
        const auto at = std::lower_bound(nodes.begin(), nodes.end(), found->second);
        if (at != nodes.end() && *at == found->second)
            places.push_back({static_cast<int>(i), static_cast<int>(at - nodes.begin())});
    }
    if (looked_at.empty())
        throw ExplainError(fmt::format("the deck has no interface {}; it has {}", request.interface.value_or(0),
                                       interface_ids(model)));
    if (places.empty())
        throw ExplainError(
            fmt::format("node {} is not on the secondary side ({}): contact is computed for secondary nodes only",
                        request.node, looked_at));
    return places;
}

/// P0 that Inacti gives the node at time 0, before the first cycle changes it.
double offset_of_time_zero(const Contact& contact, const Inspect& inspect, const Model& model, const Seat& place,
                           const Motion& motion) {
    if (motion.time > 0) return 0;
    const Interface& card = model.interfaces[static_cast<size_t>(place.interface)];
    const auto n = static_cast<size_t>(place.rank);
    for (const InitialPenetration& p : contact.initial_penetrations({motion.position.begin(), motion.position.end()}))
        if (p.node == card.secondary.node[n])
            return initial_offset(inspect.inacti(), p.penetration, card.secondary.gap[n], card.depth);
    return 0;
}

}  // namespace

DeckAccount explain_deck(const HostScene& scene, const ExplainRequest& request, const MarchOptions& options) {
    const Model& model = *scene.host;
    const std::vector<Seat> places = places_of(model, request);
    const std::string unit = model.units.name(dim::time);
    const double latest = request.time * (1 + 1e-9);
    if (request.time < 0) throw ExplainError("the time is negative: a run begins at 0");
    if (request.time > model.engine.end_time * (1 + 1e-9))
        throw ExplainError(fmt::format("time {} {unit} is beyond the run, which ends at {} {unit}", request.time,
                                       model.engine.end_time, fmt::arg("unit", unit)));

    std::vector<const Contact*> contacts;
    const MakeContact make = [&](const Scene& s, int i) {
        auto contact = std::make_unique<Contact>(s, i);
        contacts.push_back(contact.get());
        return contact;
    };
    DeckAccount account;
    account.node = request.node;
    account.asked = request.time;
    std::vector<NodeBefore> before(places.size());
    const Observer observe = [&](const CycleRecord& record) {
        const bool wanted = record.last || record.time + record.next_step > latest;
        for (size_t p = 0; p < places.size(); ++p) {
            const Seat& place = places[p];
            const Contact& contact = *contacts[static_cast<size_t>(place.interface)];
            const Inspect inspect(contact);
            if (record.cycle == 0)
                before[p].penetration.offset = offset_of_time_zero(contact, inspect, model, place, *record.motion);
            if (wanted) {
                const ContactStep& step = (*record.contacts)[static_cast<size_t>(place.interface)];
                account.interfaces.push_back(
                    account_node({scene, place.interface, place.rank, inspect, *record.motion, step, before[p]}));
            }
            before[p] = {inspect.history(place.rank), inspect.remembered_friction(place.rank)};
        }
        if (!wanted) return;
        account.cycle = record.cycle;
        account.time = record.time;
        account.step = record.step;
        throw Found{};
    };
    try {
        march(scene, make, observe, options);
    } catch (const Found&) {
        return account;
    }
    throw ExplainError(fmt::format("the run has no cycle at time {} {}", request.time, unit));
}

}  // namespace type21
