#include "verification/performance/accuracy/effect_cost.h"

#include <array>
#include <memory>
#include <tbb/global_control.h>

#include "optimized/contact.h"
#include "reference/cycle/contact.h"
#include "verification/performance/accuracy/effect_scene.h"

namespace type21::accuracy {

namespace {

constexpr int warm_up = 3;  // cycles that are not counted: first searches, first slip

/// One contact with its own scene.
struct Stepped {
    std::unique_ptr<EffectScene> scene;
    std::unique_ptr<ContactMethod> contact;
    std::vector<double> ns;  ///< per node, a value a cycle
    double output = 0;       ///< force and heat of the last cycle, to see whether an effect acts
};

template <class Contact>
Stepped stepped(int nodes, const EffectCard& card, void (*first)(Interface&), void (*second)(Interface&)) {
    Stepped one;
    one.scene = std::make_unique<EffectScene>(nodes, [&](Interface& it) {
        card.base(it);
        first(it);
        second(it);
    });
    one.contact = std::make_unique<Contact>(one.scene->scene(), 0);
    return one;
}

void nothing(Interface&) {}

/// One cycle; its time per node is kept.
void step(Stepped& one, int cycle, bool lean) {
    const Motion motion = one.scene->motion(cycle);
    const double nodes = static_cast<double>(one.scene->scene().model->interfaces[0].secondary.node.size());
    ContactSums sums;
    double tool = 0;
    const Watch watch(true);
    if (auto* fast = lean ? dynamic_cast<optimized::Contact*>(one.contact.get()) : nullptr) {
        const optimized::LeanStep& done = fast->step_lean(motion);
        sums = done.sums;
        tool = done.tool.damping;
    } else {
        const ContactStep done = one.contact->step(motion);
        sums = done.sums;
        tool = done.tool.damping;
        for (const double ratio_so_far : done.skid)
            tool += ratio_so_far;
    }
    const double ns = watch.nanoseconds() / nodes;
    if (cycle >= warm_up) one.ns.push_back(ns);
    one.output = sums.norm_total + sums.tangential.norm() + sums.elastic_energy + sums.heat_to_blank + tool;
}

std::vector<double> ratio(const std::vector<double>& above, const std::vector<double>& below) {
    std::vector<double> out;
    out.reserve(above.size());
    for (size_t i = 0; i < above.size(); ++i)
        out.push_back(above[i] / below[i]);
    return out;
}

size_t bytes(const ContactMethod& contact) {
    size_t sum = 0;
    for (const EffectMemory& memory : contact.memory_by_effect())
        sum += memory.bytes_per_node;
    return sum;
}

template <class Contact>
EffectCost cost_of(const EffectCard& card, const char* implementation, int nodes, int cycles) {
    std::array<Stepped, 4> all{
        stepped<Contact>(nodes, card, nothing, nothing), stepped<Contact>(nodes, card, nothing, nothing),
        stepped<Contact>(nodes, card, card.off, nothing), stepped<Contact>(nodes, card, card.off, card.on)};
    auto& [absent, again, off, on] = all;
    const bool lean = card.lean && std::string(implementation) == "optimized";
    for (int cycle = 0; cycle < cycles + warm_up; ++cycle)
        for (size_t i = 0; i < all.size(); ++i)
            step(all[(i + static_cast<size_t>(cycle)) % all.size()], cycle, lean);
    EffectCost cost;
    cost.effect = card.name;
    cost.off_means = card.off_means;
    cost.implementation = implementation;
    cost.lean = lean;
    cost.nodes = static_cast<size_t>(nodes) * static_cast<size_t>(nodes);
    cost.cycles = static_cast<size_t>(cycles);
    cost.absent = timing_spread(absent.ns);
    cost.off = timing_spread(off.ns);
    cost.on = timing_spread(on.ns);
    std::vector<double> extra;
    extra.reserve(on.ns.size());
    for (size_t i = 0; i < on.ns.size(); ++i)
        extra.push_back(on.ns[i] - off.ns[i]);
    const std::vector<double> off_ratio = ratio(off.ns, absent.ns);
    cost.extra = percentile(extra, 0.5);
    cost.extra_error = error_of_median(extra);
    cost.off_ratio = percentile(off_ratio, 0.5);
    cost.off_error = error_of_median(off_ratio);
    cost.same_ratio = percentile(ratio(again.ns, absent.ns), 0.5);
    cost.same_program = off.scene->scene().effects == absent.scene->scene().effects;
    cost.bytes_absent = bytes(*absent.contact);
    cost.bytes_off = bytes(*off.contact);
    cost.bytes_on = bytes(*on.contact);
    cost.changes_forces = on.output != off.output;
    return cost;
}

}  // namespace

EffectCost effect_cost(const EffectCard& card, bool fast, int nodes, int cycles) {
    // One thread: its processor time is that of the step.
    const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
    return fast ? cost_of<optimized::Contact>(card, "optimized", nodes, cycles)
                : cost_of<reference::Contact>(card, "reference", nodes, cycles);
}

std::vector<EffectCost> effect_costs(bool quick, const std::function<void(const std::string&)>& progress) {
    std::vector<EffectCost> costs;
    for (const EffectCard& card : effect_cards()) {
        if (progress) progress("effect: " + card.name);
        costs.push_back(effect_cost(card, false, quick ? 12 : 20, quick ? 15 : 60));
        costs.push_back(effect_cost(card, true, quick ? 48 : 80, quick ? 60 : 300));
    }
    return costs;
}

}  // namespace type21::accuracy
