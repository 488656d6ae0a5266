// Shipped decks with one number that makes no sense: refused, stopped or finite to the end, but never nonsense and
// never endless.
#include <cmath>

#include <gtest/gtest.h>

#include "reference/contract/make_contact.h"
#include "reference/host/prepare_deck.h"
#include "verification/tests/deck/problem_search.h"

namespace type21::bad_decks {
namespace {

struct Change {
    std::string from, to;
};

/// What became of a deck.
struct Outcome {
    Problems problems;
    bool ran = false;
    long cycles = 0;
    std::string stop;
    std::vector<std::string> warnings;
    bool finite = true;  ///< every number that a record held
};

std::string all_replaced(std::string text, const Change& change) {
    EXPECT_NE(text.find(change.from), std::string::npos) << change.from;
    for (size_t at = 0; (at = text.find(change.from, at)) != std::string::npos; at += change.to.size())
        text.replace(at, change.from.size(), change.to);
    return text;
}

std::string text_of(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

bool is_finite(const CycleRecord& r) {
    bool finite = true;
    const auto look = [&](const Vec3& v) { finite = finite && v.allFinite(); };
    for (const auto* vectors : {r.displacement, r.angular_velocity, r.acceleration, r.reaction, r.reaction_moment}) {
        for (const Vec3& v : *vectors)
            look(v);
    }
    for (const Vec3& v : r.motion->velocity)
        look(v);
    for (const InterfaceTotals& t : *r.totals) {
        for (const Vec3& v : {t.normal, t.tangential, t.abs_normal, t.abs_total})
            look(v);
        finite = finite && std::isfinite(t.signed_normal + t.norm_total + t.friction_heat + t.elastic_energy +
                                         t.friction_energy + t.damping_energy + t.heat_to_blank + t.heat_to_tool);
    }
    return finite;
}

Outcome outcome(const std::string& name, const std::vector<Change>& starter, const std::vector<Change>& engine = {}) {
    const std::string stem = std::string(TYPE21_SOURCE_DIR) + "/cases/" + name + "/" + name;
    std::string text = text_of(stem + "_0000.rad");
    std::string control = text_of(stem + "_0001.rad");
    for (const Change& change : starter)
        text = all_replaced(text, change);
    for (const Change& change : engine)
        control = all_replaced(control, change);
    const test::TempFolder folder;
    const std::string path = folder.write(name + "_0000.rad", text);
    folder.write(name + "_0001.rad", control);
    Outcome result;
    const PreparedDeck prepared = prepare_deck(path, "", true);
    result.problems = prepared.problems;
    if (!prepared.scene) return result;
    result.ran = true;
    MarchOptions options;
    options.warn = [&](const std::string& warning) { result.warnings.push_back(warning); };
    try {
        march(
            *prepared.scene, [](const Scene& scene, int i) { return optimized::make_contact(scene, i); },
            [&](const CycleRecord& r) {
                result.cycles = r.cycle + 1;
                result.finite = result.finite && is_finite(r);
            },
            options);
    } catch (const RunStopped& stopped) {
        result.stop = stopped.what();
    }
    return result;
}

const Change hundred_times{"               2e-06               2e-06", "               2e-04               2e-04"};

TEST(BadDecks, StepsFarAboveTheLimitAreStoppedByTheEnergy) {
    for (const char* name : {"tool_drop_damp", "tool_drop", "tool_tilt_free"}) {
        const Outcome o = outcome(name, {}, {hundred_times, {"0.000799", "0.0799"}});
        ASSERT_TRUE(o.ran) << name << "\n" << test::all_of(o.problems);
        EXPECT_NE(o.stop.find("energy grows"), std::string::npos) << name << ": " << o.stop;
        ASSERT_EQ(o.warnings.size(), 1U) << name;
        EXPECT_NE(o.warnings[0].find("above the stability limit"), std::string::npos) << o.warnings[0];
    }
}

TEST(BadDecks, TheirOwnStepIsNoMatter) {
    const Outcome o = outcome("tool_drop_damp", {});
    EXPECT_EQ(o.stop, "");
    EXPECT_TRUE(o.warnings.empty()) << o.warnings[0];
}

TEST(BadDecks, AStepThatIsLostInTheTimeIsRefused) {
    for (const char* step : {"5e-324", "1e-25", "1e-30"}) {
        const Outcome o = outcome("cylinder_slide", {},
                                  {{"               2e-06               2e-06", std::string(step) + " " + step}});
        EXPECT_FALSE(o.ran) << step;
        EXPECT_NE(test::find_rule(o.problems, "t + dt = t"), nullptr) << test::all_of(o.problems);
    }
}

/// Neither nonsense nor an endless run.
void expect_sense(const Outcome& o, const std::string& what) {
    EXPECT_TRUE(o.finite) << what;
    EXPECT_TRUE(!o.ran || o.cycles > 0 || !o.stop.empty()) << what;
    if (!o.stop.empty()) {
        EXPECT_NE(o.stop.find("in cycle "), std::string::npos) << what << ": " << o.stop;
    }
}

TEST(BadDecks, HugeNumbersAreRefusedOrStopTheRunByName) {
    const std::vector<Change> few_cycles{{"0.000799", "0.0000199"}};
    const std::string density = "             7.8e-06";
    for (const char* huge : {"               1e300", "               1e150", "               1e110"}) {
        expect_sense(outcome("cylinder_slide", {{density, huge}}, few_cycles), std::string("density ") + huge);
        expect_sense(outcome("cylinder_slide", {{"            210000.0", huge}}, few_cycles),
                     std::string("Young ") + huge);
        expect_sense(outcome("cylinder_slide", {{"                 1.2", huge}}, few_cycles),
                     std::string("thickness ") + huge);
        expect_sense(outcome("cylinder_slide", {{"              4000.0", huge}}, few_cycles),
                     std::string("velocity ") + huge);
        expect_sense(outcome("cylinder_slide",
                             {{"                 0.0                 1.0\n              1000.0                 1.0",
                               "                 0.0                 1.0\n              1000.0" + std::string(huge)}},
                             few_cycles),
                     std::string("function ") + huge);
        expect_sense(
            outcome("tool_drop", {{"                0.02       101", std::string(huge) + "       101"}}, few_cycles),
            std::string("mass ") + huge);
        expect_sense(outcome("tool_drop", {{"           -300000.0", huge}}, few_cycles), std::string("load ") + huge);
    }
    // The shown one: densities of 1e300 give masses that overflow in products.
    const Outcome shown = outcome("cylinder_slide", {{density, "               1e300"}}, few_cycles);
    EXPECT_FALSE(shown.ran);
    EXPECT_NE(test::find_rule(shown.problems, "the mass of a node"), nullptr) << test::all_of(shown.problems);
}

}  // namespace
}  // namespace type21::bad_decks
