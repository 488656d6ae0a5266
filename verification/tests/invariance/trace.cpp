#include "trace.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/cycle/contact.h"
#include "reference/deck/deck.h"
#include "reference/model/model.h"
#include "reference/model/resolve.h"

namespace type21::test {
namespace {

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

Model model_of(const std::string& starter, const std::string& engine) {
    Problems problems;
    const Deck deck = read_deck({{"case_0000.rad", starter}, {"case_0001.rad", engine}}, problems);
    Model model = resolve(deck, AsBuilt(), problems);
    if (problems.has_errors()) throw std::runtime_error(to_text(problems.list().front()));
    return model;
}

std::string path_of(const std::string& name, const char* ending) {
    return fmt::format("{}/cases/{}/{}_{}.rad", TYPE21_SOURCE_DIR, name, name, ending);
}

}  // namespace

Trace run(const Model& model) {
    Trace trace;
    const auto nodes = static_cast<size_t>(model.nodes.size());
    const MakeContact make = [](const Scene& s, int i) { return std::make_unique<reference::Contact>(s, i); };
    const auto observe = [&](const CycleRecord& record) {
        trace.totals = *record.totals;
        ++trace.cycles;
        const bool keep = record.cycle % 25 == 0 || record.last;
        if (keep) {
            Snapshot shot;
            shot.cycle = record.cycle;
            shot.time = record.time;
            shot.place.assign(record.motion->position.begin(), record.motion->position.end());
            shot.temperature = *record.temperature;
            shot.force.assign(nodes, Vec3::Zero());
            shot.decision.resize(nodes);
            trace.snapshots.push_back(std::move(shot));
        }
        for (size_t i = 0; i < model.interfaces.size(); ++i) {
            const auto& contacts = (*record.contacts)[i].nodes;
            for (size_t n = 0; n < contacts.size(); ++n) {
                const auto node = static_cast<size_t>(model.interfaces[i].secondary.node[n]);
                trace.in_contact += contacts[n].decision.kind == Kind::contact ? 1 : 0;
                trace.largest_force = std::max(trace.largest_force, contacts[n].force.norm());
                if (!keep) continue;
                trace.snapshots.back().force[node] += contacts[n].force;
                trace.snapshots.back().decision[node] = contacts[n].decision;
            }
        }
    };
    march(plan(std::make_shared<const Model>(model)), make, observe);
    for (const InterfaceTotals& totals : trace.totals)
        trace.largest_impulse = std::max(trace.largest_impulse, totals.norm_total);
    return trace;
}

Model case_model(const std::string& name) {
    return model_of(text_of(path_of(name, "0000")), text_of(path_of(name, "0001")));
}

Model case_model_in(const std::string& name, const std::string& mass, const std::string& length,
                    const std::string& time) {
    std::string starter = text_of(path_of(name, "0000"));
    // The two lines of units behind /BEGIN: those of the deck, then those of the work.
    const std::string units = fmt::format("{:>20}{:>20}{:>20}\n", "Mg", "mm", "s");
    const size_t at = starter.find(units + units);
    EXPECT_NE(at, std::string::npos) << name << " is not in Mg, mm, s";
    if (at != std::string::npos) {
        starter.replace(at + units.size(), units.size(), fmt::format("{:>20}{:>20}{:>20}\n", mass, length, time));
    }
    return model_of(starter, text_of(path_of(name, "0001")));
}

}  // namespace type21::test
