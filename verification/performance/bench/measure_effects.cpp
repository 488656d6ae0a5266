#include <functional>
#include <tbb/task_arena.h>

#include <fmt/format.h>

#include "verification/performance/bench/bare_step.h"
#include "verification/performance/bench/bench.h"
#include "verification/performance/bench/contact_run.h"

namespace type21::bench {

namespace {

/// What switches an effect on in the bowl.
struct EffectCase {
    std::string name;
    bool with_friction;  ///< the scene without it: with damping and Coulomb friction, or elastic only
    std::vector<Effect> effects;
    std::function<void(Interface&, Model&)> change;
};

/// Shells of the blank, one material and part, for the effects that ask elements.
void add_shells(Interface&, Model& model) {
    Material material;
    material.law = MaterialLaw::elastic;
    HeatMaterial heat;
    heat.initial_temperature = 300;
    heat.heat_capacity = 3.6e-3;
    heat.conductivity_a = 5e-5;
    material.heat = heat;
    model.materials.push_back(material);
    Part part;
    part.material = 0;
    model.parts.push_back(part);
    for (Segment& segment : model.surfaces[0].segments) {
        Shell shell;
        shell.node = segment.node;
        shell.part = 0;
        shell.thickness = 1;
        segment.shell = static_cast<int>(model.shells.size());
        model.shells.push_back(shell);
    }
}

std::vector<EffectCase> cases() {
    const auto law = [](int ifric, std::array<double, 6> c) {
        return [=](Interface& card, Model&) {
            card.ifric.value = ifric;
            for (size_t i = 0; i < c.size(); ++i)
                card.c[i].value = c[i];
        };
    };
    std::vector<EffectCase> all;
    all.push_back({"damping", false, {Effect::damping}, [](Interface& card, Model&) { card.viss.value = 1; }});
    all.push_back(
        {"Coulomb friction", false, {Effect::friction}, [](Interface& card, Model&) { card.fric.value = 0.1; }});
    all.push_back({"friction filter", true, {Effect::friction_filter}, [](Interface& card, Model&) {
                       card.ifiltr.value = 1;
                       card.xfreq.value = 0.3;
                   }});
    all.push_back({"viscous friction", true, {}, law(1, {1e-3, 1e-3, 1e-4, 0, 0, 0})});
    all.push_back({"Darmstadt friction", true, {}, law(2, {1e-3, -1, 1e-3, -1, 1e-3, -1})});
    all.push_back({"Renard friction", true, {}, law(3, {0.1, 0.12, 0.2, 0.08, 0.05, 0.2})});
    all.push_back({"exponential friction", true, {}, law(4, {0.05, 10, 0, 0, 0, 0})});
    all.push_back({"Pmax", true, {Effect::pmax_limit}, [](Interface& card, Model&) {
                       card.igap.value = 2;
                       card.pmax.value = 1;
                   }});
    all.push_back({"gap growth (Igap 2)", true, {Effect::gap_growth}, [](Interface& card, Model& model) {
                       card.igap.value = 2;
                       card.fscalegap.value = 1;
                       add_shells(card, model);
                   }});
    all.push_back({"heat", true, {Effect::heat}, [](Interface& card, Model& model) {
                       card.ithe.value = 1;
                       card.kthe.value = 1e-3;
                       card.tint.value = 500;
                       card.fheat.value = 1;
                       card.drad.value = 0.5;
                       card.frad.value = 1e-14;
                       add_shells(card, model);
                   }});
    all.push_back({"skid line", true, {Effect::skid_line}, [](Interface& card, Model&) { card.pskid.value = 1; }});
    all.push_back(
        {"normals test (Invn)", true, {Effect::normals_test}, [](Interface& card, Model&) { card.invn.value = 1; }});
    all.push_back({"adaptive data (Iadm)", true, {Effect::adaptive_data}, [](Interface& card, Model&) {
                       card.iadm.value = 2;
                       card.nradm.value = 3;
                   }});
    return all;
}

/// The bowl with some effects more, and with what its motion then needs.
BenchScene changed(const BenchScene& bowl, bool with_friction, const EffectCase* with) {
    BenchScene out = bowl;
    auto model = std::make_shared<Model>(*bowl.scene.host);
    Interface& card = model->interfaces[0];
    std::vector<Effect>& effects = out.scene.effects[0];
    effects = {Effect::elastic};
    card.viss.value = card.fric.value = 0;
    if (with_friction) {
        card.viss.value = 1;
        card.fric.value = 0.1;
        effects = {Effect::elastic, Effect::damping, Effect::friction};
    }
    if (with != nullptr) {
        with->change(card, *model);
        effects.insert(effects.end(), with->effects.begin(), with->effects.end());
    }
    out.scene.model = model;
    const auto thickness = std::make_shared<std::vector<double>>(model->shells.size(), 1.0);
    const auto temperature = std::make_shared<std::vector<double>>(model->nodes.position.size(), 300.0);
    const bool grows = out.scene.has(0, Effect::gap_growth), heated = out.scene.has(0, Effect::heat);
    out.motion = [before = bowl.motion, thickness, temperature, grows, heated](int cycle) {
        Motion motion = before(cycle);
        if (grows) motion.thickness = *thickness;
        if (heated) motion.temperature = *temperature;
        return motion;
    };
    return out;
}

}  // namespace

void measure_effects(const BenchOptions& options, BenchResult& result) {
    const Effort effort(options.quick);
    // A quarter of the bowl: which effects cost what does not hang on its size.
    const BenchScene bowl = bowl_bench(options.blank / 2, options.tool / 2);
    const BenchScene elastic = changed(bowl, false, nullptr), with_friction = changed(bowl, true, nullptr);
    tbb::task_arena one(1);
    one.execute([&] {
        BareRun bare[2] = {{elastic, false}, {with_friction, true}};
        ContactRun without[2] = {ContactRun(elastic), ContactRun(with_friction)};
        for (int i = 0; i < 2; ++i) {
            bare[i].settle();
            without[i].settle();
        }
        Rounds rounds;
        const std::vector<EffectCase> all = cases();
        std::vector<BenchScene> scenes;
        for (const EffectCase& one_case : all)
            scenes.push_back(changed(bowl, one_case.with_friction, &one_case));
        std::vector<std::unique_ptr<ContactRun>> with;
        for (const BenchScene& scene : scenes) {
            with.push_back(std::make_unique<ContactRun>(scene));
            with.back()->settle();
            with.back()->next(true);
        }
        for (size_t i = 0; i < 2; ++i) {
            const std::string base = i == 1 ? "with_friction" : "elastic";
            rounds.add(
                "bare " + base, [&run = bare[i]] { return run.next(); }, effort.cycles);
            rounds.add(
                "off " + base, [&run = without[i]] { return run.next(true); }, effort.cycles);
            rounds.add(
                "off with report " + base, [&run = without[i]] { return run.next(false); }, effort.cycles);
        }
        for (size_t i = 0; i < all.size(); ++i)
            rounds.add(
                all[i].name, [run = with[i].get()] { return run->next(true); }, effort.cycles);
        rounds.run(effort.repeats, effort.seconds);
        for (size_t i = 0; i < all.size(); ++i) {
            const std::string base = all[i].with_friction ? "with_friction" : "elastic";
            const bool lean = with[i]->has_lean();
            EffectRow row{all[i].name,
                          lean ? "step_lean" : "step",
                          rounds.of((lean ? "off " : "off with report ") + base).p50,
                          rounds.of(all[i].name).p50,
                          {}};
            if (lean) row.ns_absent = rounds.of("bare " + base).p50;
            result.effects.push_back(row);
        }
        result.targets.push_back({"memory of a node without optional effects", "bowl", "B", Better::lower, 100, 100,
                                  static_cast<double>(without[0].contact().bytes_per_node()), ""});
        for (const std::string base : {"elastic", "with_friction"})
            result.targets.push_back({fmt::format("effects off against a step that has none, {}",
                                                  base == "elastic" ? "elastic" : "Coulomb and damping"),
                                      "bowl", "x", Better::lower, 1.02, 1.00,
                                      rounds.of_medians("off " + base, "bare " + base),
                                      "the other is written by hand"});
    });
}

}  // namespace type21::bench
