#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::Outcome;
using test::TempFolder;

TEST(Usage, NoArgumentsIsHelpOnStderrAndExitOne) {
    const Outcome outcome = test::type21("");
    EXPECT_EQ(outcome.code, 1);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("Exit codes"), std::string::npos);
}

TEST(Usage, HelpAndVersionAreNoErrors) {
    EXPECT_EQ(test::type21("--help").code, 0);
    for (const char* verb : {"check", "run", "compare", "verify", "departures"}) {
        const Outcome outcome = test::type21(std::string(verb) + " --help");
        EXPECT_EQ(outcome.code, 0) << verb;
        EXPECT_NE(outcome.out.find(verb), std::string::npos);
    }
    const Outcome version = test::type21("--version");
    EXPECT_EQ(version.code, 0);
    EXPECT_TRUE(version.out.starts_with("type21 ")) << version.out;
}

TEST(Usage, DeparturesAsJsonSayWhatTheTextSays) {
    TempFolder folder;
    const Outcome outcome = test::type21("departures --json " + test::in_quotes(folder / "d.json"));
    ASSERT_EQ(outcome.code, 0) << outcome.err;
    const auto rows = nlohmann::json::parse(test::read_text(folder / "d.json"));
    ASSERT_EQ(rows.size(), 44U);
    size_t unavailable = 0;
    for (const auto& row : rows) {
        EXPECT_NE(outcome.out.find(row["id"].get<std::string>() + "  " +
                                   (row["available"] == true ? "available" : "not available")),
                  std::string::npos)
            << row;
        EXPECT_NE(outcome.out.find(row["as_built"].get<std::string>()), std::string::npos) << row;
        EXPECT_NE(outcome.out.find(row["documented"].get<std::string>()), std::string::npos) << row;
        unavailable += row["available"] == false ? 1 : 0;
        EXPECT_EQ(row["available"] == true, row["reason"] == "") << row;
    }
    EXPECT_GE(unavailable, 1U);
}

TEST(Usage, AWrongCommandLineIsExitOneWithAWord) {
    TempFolder folder;
    const std::string empty = "'" + folder.path().string() + "'";
    const std::string deck = "'" + (test::cases() / "flat_press/flat_press_0000.rad").string() + "'";
    for (const std::string& arguments :
         {std::string("chek x.rad"), std::string("--wrong"), std::string("check"), "check " + deck + " --wrong",
          "check " + deck + " extra", "run " + deck, "run " + deck + " --out x --with magic",
          "run " + deck + " --out x --with optimized --search magic", std::string("fuzz --count 1 --search sorted"),
          "run " + deck + " --out x --as-built D99", "check " + deck + " --as-built nonsense", std::string("compare"),
          "compare " + empty, "compare /no/such/folder " + empty, "compare " + empty + " " + empty + " --tolerance -1",
          "compare " + empty + " " + empty + " --tolerance x", std::string("verify --jobs 0")}) {
        const Outcome outcome = test::type21(arguments);
        EXPECT_EQ(outcome.code, 1) << arguments;
        EXPECT_TRUE(outcome.err.starts_with("type21: ")) << arguments << "\n" << outcome.err;
    }
    EXPECT_NE(test::type21("chek x.rad").err.find("chek"), std::string::npos);
}

TEST(Usage, DeparturesAreListed) {
    const Outcome outcome = test::type21("departures");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("D24"), std::string::npos);
    EXPECT_NE(outcome.out.find("as built"), std::string::npos);
}

}  // namespace
}  // namespace type21
