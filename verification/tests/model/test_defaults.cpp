// Defaults of the card, what replaces them, and the departures among them.
#include <gtest/gtest.h>

#include "interface_fixture.h"
#include "reference/model/field_table.h"
#include "reference/model/model.h"

namespace type21::test {
namespace {

constexpr auto error = Severity::error;
constexpr auto warning = Severity::warning;

Interface with(const Fields& fields, const std::vector<Departure>& departures = {}, Model model = blank_over_tool()) {
    for (const Departure departure : departures)
        model.as_built.set(departure);
    Problems problems;
    const Interface it = resolve_fields(model, fields, problems);
    for (const Problem& problem : problems.list())
        EXPECT_NE(problem.severity, error) << to_text(problem);
    return it;
}

// @manual field Pskid, Bumult, AscaleK
TEST(Defaults, OfABlankCard) {
    const Interface it = with({});
    EXPECT_EQ(it.istf, 0);
    EXPECT_EQ(it.igap, 0);
    EXPECT_EQ(it.fscalegap, 1.0);
    EXPECT_EQ(it.gapmax, 1e30);
    EXPECT_EQ(it.pmax, 1e30);
    EXPECT_EQ(it.itlim, 0);
    EXPECT_EQ(it.stmin, 0.0);
    EXPECT_EQ(it.stmax, 1e30);
    EXPECT_EQ(it.pskid, 1e30);
    EXPECT_EQ(it.stfac, 1.0);
    EXPECT_EQ(it.fric, 0.0);
    EXPECT_EQ(it.tstart, 0.0);
    EXPECT_EQ(it.tstop, 1e30);
    EXPECT_EQ(it.viss, 1.0);
    EXPECT_EQ(it.bumult, 0.20);
    EXPECT_EQ(it.ascalef, 1.0);
    EXPECT_EQ(it.ascalek, 1.0) << "one MPa, the pressure unit of Mg mm s";
    EXPECT_EQ(it.nradm, 1) << "used with Iadm 2 only";
    EXPECT_EQ(it.angladm, 0.0);
    EXPECT_EQ(it.padm, 1.0);
    EXPECT_EQ(it.kthe, 0.0);
    EXPECT_EQ(it.damp, 0.0);
    EXPECT_EQ(it.sensor, -1);
    EXPECT_EQ(it.friction_model, -1);
    EXPECT_EQ(it.reference_interface, -1);
    for (const FieldRow& row : field_table(it, {})) {
        const bool given = row.name == "surf_IDs" || row.name == "surf_IDm" || row.name == "IDrby";
        EXPECT_EQ(row.origin.kind, given ? Origin::Kind::deck : Origin::Kind::fallback) << row.name;
    }
}

TEST(Defaults, AWrittenZeroIsADefaultToo) {
    const Interface it = with({{"VISs", "0.0"}, {"Tstop", "0.0"}, {"Stfac", "0.0"}});
    EXPECT_EQ(it.viss, 1.0);
    EXPECT_EQ(it.viss.origin.kind, Origin::Kind::fallback);
    EXPECT_EQ(it.tstop, 1e30);
    EXPECT_EQ(it.stfac, 1.0);
}

// @manual field Stfac, Stmin, Stmax, Bumult; comment 6, 11
TEST(Defaults, AGivenValueStays) {
    const Interface it =
        with({{"VISs", "0.2"}, {"Stfac", "3.0"}, {"Bumult", "4.0"}, {"Stmin", "2.0"}, {"Stmax", "5.0"}});
    EXPECT_EQ(it.viss, 0.2);
    EXPECT_EQ(it.stfac, 3.0) << "larger than 1 is allowed (manual page, comment 6)";
    EXPECT_EQ(it.bumult, 4.0);
    EXPECT_EQ(it.stmin, 2.0);
    EXPECT_EQ(it.stmax, 5.0);
    EXPECT_EQ(it.stmax.origin.kind, Origin::Kind::deck);
}

// @manual field Bumult; comment 10
TEST(Defaults, BumultGrowsWithTheModel) {
    const auto bumult = [](size_t nodes, const std::string& given) {
        Model model = blank_over_tool();
        model.surfaces[0].segments.resize(1);
        model.nodes.id.resize(nodes);
        model.nodes.position.resize(nodes, Vec3::Zero());
        return with({{"Bumult", given}}, {}, std::move(model)).bumult.value;
    };
    EXPECT_EQ(bumult(1'500'000, ""), 0.20);
    EXPECT_EQ(bumult(1'500'001, ""), 0.30);
    EXPECT_EQ(bumult(2'500'000, ""), 0.30);
    EXPECT_EQ(bumult(2'500'001, ""), 0.40);
    EXPECT_EQ(bumult(2'500'001, "0.1"), 0.1);
}

// @manual field Fscalegap, Gapmax, Pmax, Kthe
TEST(Defaults, IdleFieldsTakeTheValueThatDoesNothing) {
    const Interface it = with(
        {{"Fscalegap", "2.0"}, {"Gapmax", "3.0"}, {"Pmax", "4.0"}, {"Drad", "50.0"}, {"Frad", "1.0"}, {"Kthe", "2.0"}});
    EXPECT_EQ(it.fscalegap, 1.0);
    EXPECT_EQ(it.gapmax, 1e30);
    EXPECT_EQ(it.pmax, 1e30);
    EXPECT_EQ(it.drad, 0.0) << "it must not reach the step limit";
    EXPECT_EQ(it.frad, 0.0);
    EXPECT_EQ(it.kthe, 0.0);
    EXPECT_EQ(it.gapmax.origin.kind, Origin::Kind::rule);
    EXPECT_EQ(it.drad.origin.kind, Origin::Kind::rule);
    EXPECT_NE(it.drad.origin.why.find("Ithe"), std::string::npos);
    EXPECT_GT(it.drad.origin.line, 0);
}

// @manual field Istf, Stfac
TEST(Defaults, StfacOfIstf1IsNoStiffness) {
    EXPECT_EQ(with({{"Istf", "1"}}).stfac, 0.0);
    EXPECT_EQ(with({{"Istf", "1"}, {"Stfac", "700.0"}}).stfac, 700.0);
}

// @manual departure D02
TEST(Defaults, D02StfacOfIstf1IsOne) {
    const Interface it = with({{"Istf", "1"}}, {Departure::D02});
    EXPECT_EQ(it.stfac, 1.0);
    EXPECT_NE(it.stfac.origin.why.find("D02"), std::string::npos);
    EXPECT_EQ(with({{"Istf", "1"}, {"Stfac", "700.0"}}, {Departure::D02}).stfac, 700.0);
}

// @manual departure D03
TEST(Defaults, DepthOfIgap0IsReadAndD03IgnoresIt) {
    // Gap 0.6 (mean of 1, 1.4, 1, 1.4 halved), shortest edge 10.
    EXPECT_EQ(with({{"DEPTH", "2.0"}}).depth, 2.0);
    const Interface built = with({{"DEPTH", "2.0"}}, {Departure::D03});
    EXPECT_EQ(built.depth, 10.0);
    EXPECT_EQ(built.depth.origin.kind, Origin::Kind::rule);
    EXPECT_NE(built.depth.origin.why.find("D03"), std::string::npos);
    EXPECT_EQ(with({{"DEPTH", "2.0"}, {"Igap", "1"}}, {Departure::D03}).depth, 2.0) << "Igap 1 reads it";
}

Model with_sensor() {
    Model model = blank_over_tool();
    model.sensors.push_back({3, ""});
    return model;
}

// @manual field sens_ID, Tstart, Tstop; comment 20
TEST(Defaults, ASensorReplacesTstartAndTstop) {
    const Interface it = with({{"sens_ID", "3"}, {"Tstart", "0.1"}, {"Tstop", "0.2"}}, {}, with_sensor());
    EXPECT_EQ(it.sensor, 0);
    EXPECT_EQ(it.tstart, 0.0);
    EXPECT_EQ(it.tstop, 1e30);
    EXPECT_EQ(it.tstart.origin.kind, Origin::Kind::rule);
    EXPECT_NE(it.tstop.origin.why.find("sens_ID"), std::string::npos);
    Model model = with_sensor();
    Problems problems;
    resolve_fields(model, {{"sens_ID", "3"}, {"Tstart", "0.1"}, {"Tstop", "0.2"}}, problems);
    EXPECT_EQ(about(problems, "Tstart", warning).size(), 1u);
    EXPECT_EQ(about(problems, "Tstop", warning).size(), 1u);
}

// @manual departure D09
TEST(Defaults, D09IgnoresTheSensor) {
    const Interface it = with({{"sens_ID", "3"}, {"Tstart", "0.1"}, {"Tstop", "0.2"}}, {Departure::D09}, with_sensor());
    EXPECT_EQ(it.sensor, -1);
    EXPECT_EQ(it.tstart, 0.1);
    EXPECT_EQ(it.tstop, 0.2);
    EXPECT_NE(it.sens_id.origin.why.find("D09"), std::string::npos);
}

// @manual field Inacti
TEST(Defaults, InactiAsTheDeckSays) {
    for (const int inacti : {0, 1, 3, 5, 6})
        EXPECT_EQ(with({{"Inacti", std::to_string(inacti)}}).inacti, inacti);
}

// @manual departure D20
TEST(Defaults, D20TurnsInacti2To4IntoAMessage) {
    for (const std::string inacti : {"2", "3", "4"}) {
        Model model = blank_over_tool();
        model.as_built.set(Departure::D20);
        Problems problems;
        const Interface it = resolve_fields(model, {{"Inacti", inacti}}, problems);
        EXPECT_EQ(it.inacti, 0);
        EXPECT_EQ(it.inacti.origin.kind, Origin::Kind::rule);
        EXPECT_EQ(problems.error_count(), 0);
        const auto notes = about(problems, "Inacti", warning);
        ASSERT_EQ(notes.size(), 1u);
        EXPECT_EQ(notes[0].value, inacti);
    }
    EXPECT_EQ(with({{"Inacti", "5"}}, {Departure::D20}).inacti, 5);
}

Model with_friction(int ifric, int ifiltr, double xfreq) {
    Model model = blank_over_tool();
    FrictionModel friction;
    friction.id = 9;
    friction.ifric = ifric;
    friction.ifiltr = ifiltr;
    friction.xfreq = xfreq;
    friction.fallback = {0.25, {1, 2, 3, 4, 5, 6}};
    model.friction_models.push_back(friction);
    return model;
}

// @manual field fric_ID
TEST(Defaults, FrictionModelReplacesTheCard) {
    const Interface it = with({{"fric_ID", "9"}, {"Fric", "0.1"}, {"fct_IDF", "44"}}, {}, with_friction(0, 0, 0));
    EXPECT_EQ(it.friction_model, 0);
    EXPECT_EQ(it.fric, 0.25);
    EXPECT_EQ(it.fric.origin.kind, Origin::Kind::rule);
    EXPECT_NE(it.fric.origin.why.find("/FRICTION/9"), std::string::npos);
    EXPECT_EQ(it.c[5], 6.0);
    EXPECT_EQ(it.fct_idf, 0) << "unused with fric_ID, so no error either";
}

TEST(Defaults, FrictionModelBringsItsLawAndItsFilter) {
    const Interface it =
        with({{"fric_ID", "9"}, {"Ifric", "1"}, {"Ifiltr", "1"}, {"Xfreq", "0.25"}}, {}, with_friction(2, 3, 10.0));
    EXPECT_EQ(it.ifric, 2);
    EXPECT_EQ(it.ifiltr, 3);
    EXPECT_EQ(it.xfreq, 10.0);
    EXPECT_EQ(it.card_ifiltr, 1) << "D28 filters with what the card has";
    EXPECT_EQ(it.card_xfreq, 0.25);
}

// @manual field NRadm, Padm, Angladm
TEST(Defaults, NradmPadmAngladmBelongToIadm2) {
    const Interface two = with({{"Iadm", "2"}, {"Angladm", "25.0"}});
    EXPECT_EQ(two.nradm, 3);
    EXPECT_EQ(two.padm, 1.0);
    EXPECT_EQ(two.angladm, 25.0) << "in degrees";
    const Interface given = with({{"Iadm", "2"}, {"NRadm", "4"}, {"Padm", "0.5"}, {"Angladm", "25.0"}});
    EXPECT_EQ(given.nradm, 4);
    EXPECT_EQ(given.padm, 0.5);
    for (const std::string iadm : {"0", "1"}) {
        const Interface it = with({{"Iadm", iadm}, {"NRadm", "4"}, {"Padm", "0.5"}, {"Angladm", "25.0"}});
        EXPECT_EQ(it.nradm, 1);
        EXPECT_EQ(it.padm, 1.0);
        EXPECT_EQ(it.angladm, 0.0);
        EXPECT_EQ(it.nradm.origin.kind, Origin::Kind::rule);
    }
}

// @manual field Idel
TEST(Defaults, ANegativeIdelActsAsItsValue) {
    const Interface it = with({{"Idel", "-2"}});
    EXPECT_EQ(it.idel, 2);
    EXPECT_EQ(it.idel.origin.kind, Origin::Kind::rule);
}

// @manual field Pmax, ITlim
TEST(Defaults, PmaxAndItlimActWithIgap2) {
    const Interface it = with({{"Igap", "2"}, {"Pmax", "600.0"}});
    EXPECT_EQ(it.pmax, 600.0);
    EXPECT_EQ(it.itlim, 0) << "the limit is on";
    EXPECT_EQ(with({{"Igap", "2"}}).pmax, 1e30);
}

TEST(Defaults, AFilterWithoutFrequencyIsNone) {
    const Interface it = with({{"Ifiltr", "2"}});
    EXPECT_EQ(it.ifiltr, 0);
    EXPECT_EQ(it.ifiltr.origin.kind, Origin::Kind::rule);
}

}  // namespace
}  // namespace type21::test
