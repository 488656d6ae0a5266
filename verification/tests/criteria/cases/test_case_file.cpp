#include <algorithm>

#include <gtest/gtest.h>

#include "verification/criteria/cases/case_file.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;
using test::write_text;

const std::string head =
    "statement = \"s\"\nsource = \"o\"\nfeatures = [\"f\"]\ndeck = \"d_0000.rad\"\n"
    "[[run]]\nname = \"a\"\nas_built = \"all,-D04\"\n";

/// A folder with a deck, a measured file and the given case.toml.
struct CaseFolder {
    TempFolder folder;
    std::vector<std::string> problems;
    Case a_case;

    explicit CaseFolder(const std::string& toml) {
        write_text(folder / "d_0000.rad", "");
        write_text(folder / "interface_1.csv", "time,FNX\n0,0\n");
        write_text(folder / "tool.csv", "time,node,DX\n0,1,0\n");
        write_text(folder / "case.toml", toml);
        a_case = read_case(folder.path(), problems);
    }
    bool complains(const std::string& text) const {
        return std::any_of(problems.begin(), problems.end(),
                           [&](const std::string& p) { return p.find(text) != std::string::npos; });
    }
    std::string all() const {
        std::string out;
        for (const std::string& problem : problems)
            out += problem + "\n";
        return out;
    }
};

std::string check(const std::string& form, const std::string& common = "tolerance = 1e-9\nreason = \"r\"\n") {
    return "[[criterion]]\nid = \"c\"\nrun = \"a\"\nkind = \"EXTERNAL\"\n" + common + form;
}

TEST(CaseFile, FamilyIsOneOfTheFourOrAbsent) {
    const std::string rest = head + check("balance=\"force\"\n");
    EXPECT_EQ(CaseFolder(rest).a_case.family, "");
    const CaseFolder patch("family = \"patch test\"\n" + rest);
    EXPECT_TRUE(patch.problems.empty()) << patch.all();
    EXPECT_EQ(patch.a_case.family, "patch test");
    const CaseFolder wrong("family = \"patch\"\n" + rest);
    EXPECT_TRUE(wrong.complains("case.toml:1: ")) << wrong.all();
    EXPECT_TRUE(wrong.complains("family 'patch' must be one of: patch test, sliding continuity")) << wrong.all();
}

TEST(CaseFile, ReadsTheSixForms) {
    const CaseFolder folder(
        head + "[[run]]\nname = \"b\"\n" +
        "[[criterion]]\nid=\"1\"\nrun=\"a\"\nkind=\"EXTERNAL\"\ntolerance=1e-9\nreason=\"r\"\nreference=\"tool.csv\"\n"
        "columns=[\"DX\"]\nexclude=[\"DY\"]\nnodes=[1]\nfrom=1\nuntil=2.5\n"
        "[[criterion]]\nid=\"2\"\nrun=\"b\"\nkind=\"ANALYTIC\"\ntolerance=0\nreason=\"r\"\nequation=\"e\"\nfile="
        "\"nodes."
        "csv\"\ncolumn=\"DX\"\n"
        "at=1e-3\nnode=7\nexpected=-2\nunit=\"mm\"\n"
        "[[criterion]]\nid=\"3\"\nrun=\"b\"\nkind=\"EXACT\"\ntolerance=1e-12\nreason=\"r\"\nbalance="
        "\"power\"\ninterface="
        "1\n"
        "[[criterion]]\nid=\"4\"\nrun=\"b\"\nkind=\"REGRESSION\"\nexpect_exit=2\nmessage=\"DEPTH.*mm\"\n"
        "[[criterion]]\nid=\"5\"\nrun=\"b\"\nkind=\"CROSS\"\nexpect_stop=\"node 7\"\n"
        "[[criterion]]\nid=\"6\"\nrun=\"b\"\nkind=\"EXTERNAL\"\ntolerance=0.1\nreason=\"r\"\ndiffers_from=\"interface_"
        "1."
        "csv\"\n"
        "column=\"FNX\"\nat=\"max\"\nby=0\nabsolute=true\nunit=\"N s\"\n");
    ASSERT_TRUE(folder.problems.empty()) << folder.all();
    const Case& c = folder.a_case;
    ASSERT_EQ(c.runs.size(), 2U);
    EXPECT_EQ(c.runs[0].as_built, "all,-D04");
    EXPECT_EQ(c.runs[1].deck, folder.folder / "d_0000.rad");
    ASSERT_EQ(c.criteria.size(), 6U);
    const FileRule& rule = std::get<HistoryCriterion>(c.criteria[0].form).rule;
    EXPECT_EQ(rule.ours, "nodes.csv");
    EXPECT_EQ(rule.options.columns, (std::vector<std::string>{"DX"}));
    EXPECT_EQ(rule.options.exclude, (std::vector<std::string>{"DY"}));
    EXPECT_EQ(rule.options.objects, (std::vector<Id>{1}));
    EXPECT_EQ(rule.options.window.from, 1);
    EXPECT_EQ(rule.options.window.until, 2.5);
    EXPECT_EQ(rule.options.tolerance, 1e-9);
    const auto& value = std::get<ValueCriterion>(c.criteria[1].form);
    EXPECT_EQ(value.at.kind, At::Kind::time);
    EXPECT_EQ(value.at.time, 1e-3);
    EXPECT_EQ(value.object, 7);
    EXPECT_EQ(value.expected, -2);
    EXPECT_EQ(c.criteria[1].run, 1U);
    EXPECT_EQ(c.criteria[1].equation, "e");
    EXPECT_EQ(c.criteria[1].unit, "mm");
    EXPECT_EQ(std::get<BalanceCriterion>(c.criteria[2].form).interface, 1);
    EXPECT_EQ(std::get<RefusalCriterion>(c.criteria[3].form).message, "DEPTH.*mm");
    EXPECT_EQ(std::get<StopCriterion>(c.criteria[4].form).message, "node 7");
    const auto& departure = std::get<DepartureCriterion>(c.criteria[5].form);
    EXPECT_EQ(departure.at.kind, At::Kind::largest);
    EXPECT_EQ(departure.file, "interface_1.csv");
    EXPECT_TRUE(departure.absolute);
}

TEST(CaseFile, ACheckMayBeAskedOfOneImplementation) {
    const std::string form = "reference = \"tool.csv\"\n";
    const CaseFolder good(head + check(form + "with = \"reference\"\n"));
    EXPECT_TRUE(good.problems.empty()) << good.all();
    EXPECT_EQ(good.a_case.criteria.at(0).with, "reference");
    const CaseFolder bad(head + check(form + "with = \"abacus\"\n"));
    EXPECT_TRUE(bad.complains("with 'abacus' must be reference or optimized")) << bad.all();
}

TEST(CaseFile, NamesFileAndLine) {
    const CaseFolder syntax(head + "[[criterion]\n");
    ASSERT_EQ(syntax.problems.size(), 1U);
    EXPECT_NE(syntax.problems[0].find("case.toml:8:"), std::string::npos) << syntax.all();
    const CaseFolder unknown(head + check("reference = \"interface_1.csv\"\ncolums = [\"FNX\"]\n"));
    ASSERT_EQ(unknown.problems.size(), 1U) << unknown.all();
    EXPECT_NE(unknown.problems[0].find("case.toml:15: [[criterion]] 'c': unknown key 'colums'"), std::string::npos)
        << unknown.all();
}

TEST(CaseFile, ComplainsAboutEveryMistake) {
    const auto complains = [](const std::string& toml, const std::string& text) {
        const CaseFolder folder(toml);
        EXPECT_TRUE(folder.complains(text)) << "expected: " << text << "\ngot: " << folder.all();
    };
    const std::string good = "reference = \"interface_1.csv\"\n";
    complains("", "'statement' is missing");
    complains(head, "at least one [[criterion]]");
    complains("statement=\"s\"\nsource=\"o\"\nfeatures=[]\n", "at least one [[run]]");
    complains(head + check(good, "reason = \"r\"\n"), "'tolerance' is missing");
    complains(head + check(good, "tolerance = 1\n"), "'reason' is missing");
    complains(head + check(good, "tolerance = -1\nreason = \"r\"\n"), "'tolerance' must be");
    complains(head + check(good, "tolerance = nan\nreason = \"r\"\n"), "'tolerance' must be");
    complains(head + check(good, "tolerance = \"1\"\nreason = \"r\"\n"), "'tolerance' must be a number");
    complains(head + check("reference = \"nothing.csv\"\n"), "nothing.csv is not in the case's folder");
    complains(head + check(""), "exactly one of");
    complains(head + check(good + "balance = \"power\"\n"), "exactly one of");
    complains(head + check("balance = \"momentum\"\n"), "'balance' must be");
    complains(head + check("expect_exit = 3\nmessage = \"x\"\n", ""), "'expect_exit' must be 2");
    complains(head + check("expect_stop = \"(\"\n", ""), "not a regular expression");
    complains(head + check("file=\"f\"\ncolumn=\"c\"\nat=\"start\"\nexpected=1\nunit=\"N\"\n"), "'at' must be");
    complains(head + check("file=\"f\"\ncolumn=\"c\"\nat=\"end\"\nexpected=0\nunit=\"N\"\n"), "needs absolute = true");
    complains(head + check("file=\"f\"\ncolumn=\"c\"\nat=\"end\"\nexpected=1\n"), "'unit' is missing");
    complains(head + check(good) + check(good), "id 'c' is there twice");
    complains(head + "[[criterion]]\nid=\"c\"\nrun=\"z\"\nkind=\"EXTERNAL\"\n", "there is no [[run]] 'z'");
    complains(head + "[[criterion]]\nid=\"c\"\nrun=\"a\"\nkind=\"GUESS\"\n", "kind 'GUESS'");
    complains(head + "[[run]]\nname = \"b\"\n" + check(good), "[[run]] 'b' has no criterion");
    complains(head + "[[run]]\nname = \"../b\"\n" + check(good), "must be letters");
    complains(head + "[[run]]\nname = \"b\"\nas_built = \"D99\"\n" + check(good), "D99");
    complains(head + "[[run]]\nname = \"b\"\ndeck = \"z.rad\"\n" + check(good), "z.rad is not there");
}

TEST(CaseFile, RulesBelongToTheRunWithTheSameDepartures) {
    const CaseFolder folder(head + "[[run]]\nname = \"documented\"\n" + check("reference = \"interface_1.csv\"\n") +
                            "[[criterion]]\nid=\"d\"\nrun=\"documented\"\nkind=\"EXTERNAL\"\ntolerance=0.5\nreason="
                            "\"r\"\nreference=\"tool.csv\"\n");
    ASSERT_TRUE(folder.problems.empty()) << folder.all();
    bool foreign = true;
    std::vector<FileRule> rules = rules_of(folder.a_case, "none", foreign);
    ASSERT_EQ(rules.size(), 1U);
    EXPECT_EQ(rules[0].reference, "tool.csv");
    EXPECT_FALSE(foreign);
    rules = rules_of(folder.a_case, "D24", foreign);
    EXPECT_EQ(rules.size(), 2U);
    EXPECT_TRUE(foreign);
}

}  // namespace
}  // namespace type21
