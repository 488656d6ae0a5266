#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;
using Names = std::vector<std::string>;

HistoryRequest request(const std::string& card) {
    const Resolved r = resolved(with_cards(card));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    return r.model.histories.at(0);
}

TEST(Histories, OfInterfacesByName) {
    const HistoryRequest h =
        request("/TH/INTER/1\ncontact\nFNX       |FNX|     ||FN||    \nCE_DAMP   qfric\n         1\n");
    EXPECT_EQ(h.kind, HistoryRequest::Kind::interface);
    EXPECT_EQ(h.title, "contact");
    EXPECT_EQ(h.variables, (Names{"FNX", "|FNX|", "||FN||", "QFRIC", "CE_DAMP"})) << "in the order of Radioss";
    EXPECT_EQ(h.objects, (std::vector<int>{0}));
}

TEST(Histories, GroupNamesExpand) {
    EXPECT_EQ(request("/TH/INTER/1\nc\nDEF\n         1\n").variables,
              (Names{"FNX", "FNY", "FNZ", "FTX", "FTY", "FTZ"}));
    EXPECT_EQ(request("/TH/NODE/1\nn\nDEF       A\n         1\n").variables,
              (Names{"DX", "DY", "DZ", "VX", "VY", "VZ", "AX", "AY", "AZ"}));
    EXPECT_EQ(request("/TH/NODE/1\nn\nREACX     VRZ       DX\n         1\n").variables, (Names{"DX", "VRZ", "REACX"}));
    EXPECT_EQ(request("/TH/RBODY/1\nb\nDEF       D\n         7\n").variables,
              (Names{"FX", "FY", "FZ", "MX", "MY", "MZ", "RX", "RY", "RZ", "DX", "DY", "DZ"}));
}

TEST(Histories, OfNodesWhoseNameTouchesTheSkew) {
    const HistoryRequest h = request("/TH/NODE/1\nn\nDX\n       201         0n201\n         1         0n1\n");
    EXPECT_EQ(h.objects, (std::vector<int>{9, 0})) << "in the order of the card";
}

TEST(Histories, OfRigidBodies) {
    EXPECT_EQ(request("/TH/RBODY/1\nb\nDX\n         7\n").objects, (std::vector<int>{0}));
}

TEST(Histories, AnUnknownVariableIsAWarningAnUnknownObjectAnError) {
    const Problem variable = only(resolved(with_cards("/TH/NODE/1\nn\nDX        FOO\n         1\n")).problems);
    EXPECT_EQ(variable.severity, Severity::warning);
    EXPECT_EQ(variable.value, "FOO");
    EXPECT_EQ(only(resolved(with_cards("/TH/NODE/1\nn\nDX\n        66\n")).problems).severity, Severity::error);
    EXPECT_EQ(only(resolved(with_cards("/TH/INTER/1\nn\nDEF\n        66\n")).problems).value, "66");
    EXPECT_EQ(only(resolved(with_cards("/TH/RBODY/1\nn\nDEF\n        66\n")).problems).field, "RBODY_ID");
    EXPECT_EQ(only(resolved(with_cards("/TH/NODE/1\nn\nDX\n         1         5n\n")).problems).field, "skew_ID");
}

TEST(Histories, TemperaturesStandBetweenVelocitiesAndReactionsInASceneWithHeat) {
    // The order of a measured OpenRadioss run (commit bd4557b): VRX .., then TEMP, then REACX.
    const std::string card = "/TH/NODE/1\nn\nREACX     TEMP      VRZ       DX\n         1\n";
    const std::string heat = "/HEAT/MAT/1\n" + reals({"300.0", "3.6", "50.0"}) + "\n";
    const std::string ithe = replaced(with_cards(heat + card), ints({"1", "2"}) + std::string(10, '\n'),
                                      ints({"1", "2", "0", "1"}) + std::string(8, '\n') +
                                          "                20.0                                       900.0\n\n");
    const Resolved hot = resolved(ithe);
    EXPECT_TRUE(hot.problems.list().empty()) << all_of(hot.problems);
    EXPECT_EQ(hot.model.histories.at(0).variables, (Names{"DX", "VRZ", "TEMP", "REACX"}));
    const Resolved cold = resolved(with_cards(heat + card));
    const Problem note = only(cold.problems);
    EXPECT_EQ(note.severity, Severity::warning);
    EXPECT_EQ(note.value, "TEMP");
    EXPECT_EQ(cold.model.histories.at(0).variables, (Names{"DX", "VRZ", "REACX"}));
}

TEST(Histories, OtherKindsAreAWarning) {
    const Problem p = only(resolved(with_cards("/TH/SHEL/1\nn\nTHIC\n         1\n/TH/SHEL/2\nn\n")).problems);
    EXPECT_EQ(p.severity, Severity::warning);
    EXPECT_EQ(p.value, "/TH/SHEL (2)");
}

}  // namespace
}  // namespace type21
