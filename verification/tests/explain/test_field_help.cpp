// The words about each field: complete, and with numbers that the model gives.
#include <fstream>
#include <set>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/criteria/cases/covers.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/explain/blank_card.h"
#include "verification/explain/field_help.h"

namespace type21 {
namespace {

TEST(FieldHelp, HasEveryFieldOfTheCardInItsOrder) {
    ASSERT_EQ(field_help().size(), interface_fields().size());
    for (size_t i = 0; i < field_help().size(); ++i) {
        const FieldHelp& help = field_help()[i];
        EXPECT_EQ(help.name, interface_fields()[i].name);
        EXPECT_GT(help.meaning.size(), 20u) << help.name;
        EXPECT_GT(help.rule.size(), 10u) << help.name;
        EXPECT_TRUE(help.source.find("page") != std::string_view::npos || help.name == "fric_ID") << help.name;
    }
}

TEST(FieldHelp, IsFoundInAnyCase) {
    EXPECT_EQ(find_field_help("depth")->name, "DEPTH");
    EXPECT_EQ(find_field_help("SENS_id")->name, "sens_ID");
    EXPECT_EQ(find_field_help("DEPTHS"), nullptr);
    EXPECT_EQ(find_field_help(""), nullptr);
}

TEST(FieldHelp, ColumnsUnitAndDefaultAreThoseOfTheModel) {
    for (const InterfaceField& field : interface_fields()) {
        const std::string text = field_text(*find_field_help(field.name), {});
        EXPECT_NE(text.find(fmt::format("line {}, columns {} to {}", field.line, field.first, field.last)),
                  std::string::npos)
            << text;
    }
    const auto has = [](std::string_view name, std::string_view words) {
        const std::string text = field_text(*find_field_help(name), {});
        EXPECT_NE(text.find(words), std::string::npos) << words << "\n" << text;
    };
    has("VISs", "default     1 (0 means 1)");
    has("DEPTH", "default     0 means the larger of");
    has("NRadm", "default     3 (0 means 3)");
    has("IDrby", "none; it must be given");
    has("Pmax", "Pa");
    has("Stfac", "Istf 0: -, Istf 1: N/m");
    has("C5", "Ifric 3: m/s");
    has("DEPTH", "D03");
    has("VISs", "as built    as documented");
}

TEST(FieldHelp, CasesAreThoseThatCoverTheField) {
    const std::vector<CaseCover> cases{
        {"one", {"field DEPTH"}}, {"two", {"field DEPTHS", "departure D03"}}, {"three", {"eq 5", "field DEPTH"}}};
    EXPECT_NE(field_text(*find_field_help("DEPTH"), cases).find("cases       one, three\n"), std::string::npos);
    EXPECT_NE(departure_text(departures()[2], cases).find("cases       two\n"), std::string::npos);
    EXPECT_NE(field_text(*find_field_help("VISs"), cases).find("cases       none\n"), std::string::npos);
    EXPECT_NE(field_text(*find_field_help("VISs"), {}).find("--cases"), std::string::npos);
}

TEST(DepartureHelp, EveryDepartureThatConcernsAFieldIsNamedThere) {
    std::set<Departure> named;
    for (const FieldHelp& help : field_help())
        named.insert(help.departures.begin(), help.departures.end());
    for (const DepartureRow& row : departures()) {
        const std::string text = departure_text(row, {});
        EXPECT_NE(text.find(name(row.id)), std::string::npos);
        // These are in the computation of a contact, and no field asks for them.
        const bool of_no_field = row.id == Departure::D12 || row.id == Departure::D25 || row.id == Departure::D35 ||
                                 row.id == Departure::D44;
        EXPECT_EQ(named.contains(row.id), !of_no_field) << name(row.id);
    }
}

TEST(Covers, AreRowsThatExist) {
    for (const char* good : {"eq 1", "eq 20", "comment 24", "field fct_IDF", "departure D37", "departure D44"})
        EXPECT_TRUE(is_cover(good)) << good;
    for (const char* bad : {"eq 0", "eq 21", "eq", "eq x", "comment 25", "field depth", "departure D45", "DEPTH", ""})
        EXPECT_FALSE(is_cover(bad)) << bad;
}

TEST(Covers, OfTheShippedCasesAreRead) {
    std::vector<std::string> problems;
    size_t covers = 0;
    for (const Case& a_case : read_cases(TYPE21_SOURCE_DIR "/cases", {"depth_igap0", "stmin"}, problems))
        covers += a_case.covers.size();
    EXPECT_TRUE(problems.empty()) << problems.front();
    EXPECT_GE(covers, 4u);
}

}  // namespace
}  // namespace type21
