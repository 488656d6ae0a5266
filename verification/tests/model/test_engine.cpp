#include <gtest/gtest.h>

#include "driven_scene.h"

namespace type21 {
namespace {

using namespace test;

Resolved with_engine(const std::string& cards) {
    return resolved(driven_scene(), "#RADIOSS ENGINE\n/RUN/scene/1\n  0.001\n" + cards);
}

TEST(Engine, RunStepsAndInterval) {
    const Resolved r = with_engine("/TFILE/1\n 2e-6\n/DTIX\n 1e-7, 3e-7\n/DT/NODA/CST/0\n 0.8  0\n");
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    const EngineControl& e = r.model.engine;
    EXPECT_EQ(e.run_name, "SCENE");
    EXPECT_EQ(e.end_time, 0.001);
    EXPECT_EQ(e.history_interval, 2e-6);
    EXPECT_EQ(e.first_step, 1e-7);
    EXPECT_EQ(e.largest_step, 3e-7);
    EXPECT_TRUE(e.nodal_step);
    EXPECT_EQ(e.step_scale, 0.8);
    EXPECT_EQ(e.smallest_step, 0);
}

TEST(Engine, WhatIsLeftOutHasItsDefault) {
    const EngineControl e = with_engine("/DT/NODA/STOP\n 0 1e-9\n").model.engine;
    EXPECT_EQ(e.step_scale, 0.9);
    EXPECT_EQ(e.smallest_step, 1e-9);
    EXPECT_FALSE(e.first_step.has_value());
    EXPECT_EQ(e.history_interval, 0);
    EXPECT_FALSE(with_engine("").model.engine.nodal_step);
}

TEST(Engine, ADeckWithoutOneIsAWarning) {
    const Resolved r = resolved(driven_scene(), "");
    EXPECT_EQ(only(r.problems).severity, Severity::warning);
    EXPECT_EQ(r.model.engine.end_time, 0);
}

TEST(Engine, HarmlessKeywordsAreSilent) {
    EXPECT_TRUE(with_engine("/VERS/2025\n/PRINT/-1\n/PARITH/ON\n/MON/ON\n/RFILE/100\n/TITLE\nx\n/STOP\n 0 0 0 1 1\n")
                    .problems.list()
                    .empty());
}

TEST(Engine, OutputKeywordsAreOneWarning) {
    const Problem p = only(with_engine("/ANIM/DT\n 0 1e-4\n/ANIM/VECT/VEL\n/ANIM/ELEM/VONM\n").problems);
    EXPECT_EQ(p.severity, Severity::warning);
    EXPECT_EQ(p.value, "/ANIM (3)");
}

TEST(Engine, StopGivesALimitOfEnergyAndNoneOfMass) {
    const Resolved energy = with_engine("/STOP\n 0.1 0 0 1 1\n");
    EXPECT_TRUE(energy.problems.list().empty()) << all_of(energy.problems);
    EXPECT_EQ(energy.model.engine.energy_limit, 0.1);
    EXPECT_FALSE(with_engine("/STOP\n 0 0 0\n").model.engine.energy_limit.has_value()) << "0 is the default";
    EXPECT_EQ(only(with_engine("/STOP\n 0 0.1 0\n").problems).severity, Severity::warning);
    EXPECT_EQ(only(with_engine("/STOP\n -1 0 0\n").problems).field, "Emax");
}

TEST(Engine, OtherKeywordsAreErrorsByName) {
    for (const char* keyword : {"/DAMP", "/BCS/TRA/X", "/KEREL", "/DT/SHELL/DEL", "/DT/INTER/DEL", "/IMPL/LINEAR"}) {
        const Problem p = only(with_engine(std::string(keyword) + "\n 1\n").problems);
        EXPECT_EQ(p.severity, Severity::error);
        EXPECT_EQ(p.card, keyword);
    }
}

TEST(Engine, ValuesOutOfRange) {
    EXPECT_EQ(only(with_engine("/DT/NODA\n 1.5 0\n").problems).field, "scale factor");
    EXPECT_EQ(only(with_engine("/DT/NODA/CST/0\n 0.9 1e-7\n").problems).value, "1e-07 s");
    EXPECT_EQ(only(with_engine("/DTIX\n -1 0\n").problems).field, "DTini");
    EXPECT_EQ(only(with_engine("/TFILE\n -1\n").problems).field, "DTHIS");
    EXPECT_EQ(only(with_engine("/TFILE\n x\n").problems).value, "x");
}

TEST(Engine, RunIsThereOnceWithAPositiveTime) {
    EXPECT_EQ(only(resolved(driven_scene(), "/RUN/scene/1\n 0\n").problems).value, "0 s");
    EXPECT_EQ(only(resolved(driven_scene(), "/RUN/scene/1\n").problems).field, "Tstop");
    EXPECT_EQ(only(resolved(driven_scene(), "/RUN/scene/2\n 1\n").problems).value, "2");
    EXPECT_NE(only(resolved(driven_scene(), "/TFILE\n 1\n").problems).rule.find("/RUN"), std::string::npos);
    EXPECT_NE(only(with_engine("/RUN/scene/1\n 2\n").problems).rule.find("one /RUN"), std::string::npos);
    EXPECT_EQ(only(resolved(driven_scene(), "/RUN/other/1\n 1\n").problems).severity, Severity::warning);
}

}  // namespace
}  // namespace type21
