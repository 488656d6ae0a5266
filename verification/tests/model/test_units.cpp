#include <gtest/gtest.h>

#include "reference/model/units.h"

namespace type21 {
namespace {

const UnitSystem mg_mm_s{1e3, 1e-3, 1, "Mg", "mm", "s"};
const UnitSystem kg_mm_ms{1, 1e-3, 1e-3, "kg", "mm", "ms"};
const UnitSystem si;

TEST(Units, WordsOfRadiossDecks) {
    EXPECT_EQ(mass_unit("Mg"), 1000.0);
    EXPECT_EQ(mass_unit("kg"), 1.0);
    EXPECT_EQ(mass_unit("g"), 1e-3);
    EXPECT_EQ(mass_unit("mg"), 1e-6);
    EXPECT_EQ(mass_unit("t"), 1000.0);
    EXPECT_EQ(length_unit("mm"), 1e-3);
    EXPECT_EQ(length_unit("cm"), 1e-2);
    EXPECT_EQ(length_unit("m"), 1.0);
    EXPECT_EQ(length_unit("km"), 1e3);
    EXPECT_EQ(length_unit("in"), 0.0254);
    EXPECT_EQ(time_unit("s"), 1.0);
    EXPECT_EQ(time_unit("ms"), 1e-3);
    EXPECT_EQ(time_unit("mus"), 1e-6);
    EXPECT_EQ(time_unit("us"), 1e-6);
    EXPECT_EQ(time_unit("min"), 60.0);
    EXPECT_EQ(time_unit("h"), 3600.0);
    EXPECT_EQ(length_unit("1e-3"), 1e-3);
    EXPECT_EQ(length_unit("0.25"), 0.25);
}

TEST(Units, OtherWordsAreNone) {
    for (const char* word : {"", "mm", "MG", "stone", "0", "-1", "gk", "nan"})
        EXPECT_EQ(mass_unit(word), 0.0) << word;
    EXPECT_EQ(length_unit("s"), 0.0);
    EXPECT_EQ(time_unit("xs"), 0.0);
}

TEST(Units, ConversionByDimension) {
    EXPECT_DOUBLE_EQ(conversion(mg_mm_s, si, dim::pressure), 1e6);
    EXPECT_DOUBLE_EQ(conversion(mg_mm_s, si, dim::density), 1e12);
    EXPECT_DOUBLE_EQ(conversion(kg_mm_ms, mg_mm_s, dim::velocity), 1e3);
    EXPECT_DOUBLE_EQ(conversion(kg_mm_ms, mg_mm_s, dim::force), 1e3);
    EXPECT_DOUBLE_EQ(conversion(si, kg_mm_ms, dim::conductance), 1e-9);
    EXPECT_EQ(conversion(kg_mm_ms, kg_mm_ms, dim::conductance), 1.0) << "the same units change no bit";
    EXPECT_DOUBLE_EQ(kg_mm_ms.si(dim::energy), 1.0);
}

TEST(Units, NamesOfTheCommonSystems) {
    EXPECT_EQ(mg_mm_s.name(dim::force), "N");
    EXPECT_EQ(mg_mm_s.name(dim::pressure), "MPa");
    EXPECT_EQ(mg_mm_s.name(dim::energy), "mJ");
    EXPECT_EQ(si.name(dim::force), "N");
    EXPECT_EQ(si.name(dim::pressure), "Pa");
    EXPECT_EQ(si.name(dim::energy), "J");
    EXPECT_EQ(kg_mm_ms.name(dim::force), "kN");
    EXPECT_EQ(kg_mm_ms.name(dim::pressure), "GPa");
    EXPECT_EQ(kg_mm_ms.name(dim::energy), "J");
    EXPECT_EQ(mg_mm_s.name(dim::stiffness), "N/mm");
    EXPECT_EQ(mg_mm_s.name({1, 1, -1, 0}), "N s");
    EXPECT_EQ(kg_mm_ms.name({1, 1, -1, 0}), "kN ms");
}

TEST(Units, OtherNamesAreProducts) {
    EXPECT_EQ(mg_mm_s.name(dim::none), "");
    EXPECT_EQ(mg_mm_s.name(dim::length), "mm");
    EXPECT_EQ(mg_mm_s.name(dim::frequency), "1/s");
    EXPECT_EQ(mg_mm_s.name(dim::density), "Mg/mm^3");
    EXPECT_EQ(mg_mm_s.name(dim::inertia), "Mg mm^2");
    EXPECT_EQ(mg_mm_s.name(dim::conductance), "Mg/(s^3 K)");
    const UnitSystem pounds{0.45359237, 0.0254, 1, "lb", "in", "s"};
    EXPECT_EQ(pounds.name(dim::force), "lb in/s^2");
    EXPECT_EQ(pounds.name(dim::stiffness), "lb/s^2");
    EXPECT_EQ(pounds.name({1, 1, -1, 0}), "lb in/s");
}

}  // namespace
}  // namespace type21
