#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::Outcome;
using test::TempFolder;
namespace fs = std::filesystem;

/// A folder of cases with one of our own about flat_press.
struct Cases {
    TempFolder folder;

    explicit Cases(const std::string& criteria) {
        for (const char* name : {"flat_press_0000.rad", "flat_press_0001.rad", "interface_1.csv"}) {
            fs::create_directories(folder / "mine");
            fs::copy_file(test::cases() / "flat_press" / name, folder / ("mine/" + std::string(name)));
        }
        test::write_text(folder / "mine/case.toml",
                         "statement = \"s\"\nsource = \"o\"\nfeatures = []\ndeck = \"flat_press_0000.rad\"\n"
                         "[[run]]\nname = \"a\"\nas_built = \"all\"\n" +
                             criteria);
    }
    Outcome verify(const std::string& more = "") const {
        return test::type21("verify --cases " + test::in_quotes(folder.path()) + " --scratch " +
                            test::in_quotes(folder / "scratch") + " " + more);
    }
};

const std::string good =
    "[[criterion]]\nid=\"g\"\nrun=\"a\"\nkind=\"EXTERNAL\"\nreference=\"interface_1.csv\"\ntolerance=1e-9\nreason="
    "\"r\"\n"
    "[[criterion]]\nid=\"b\"\nrun=\"a\"\nkind=\"ANALYTIC\"\nbalance=\"power\"\ntolerance=1e-12\nreason=\"r\"\n";
const std::string bad =
    "[[criterion]]\nid=\"w\"\nrun=\"a\"\nkind=\"ANALYTIC\"\nfile=\"interface_1.csv\"\ncolumn=\"FNZ\"\nat="
    "\"end\"\nexpected="
    "1\nunit=\"N "
    "s\"\ntolerance=1e-6\nreason=\"r\"\n";

TEST(Verify, ChecksThatHoldAreExitZero) {
    const Cases cases(good);
    const Outcome outcome = cases.verify("--json " + test::in_quotes(cases.folder / "r/r.json") + " --junit " +
                                         test::in_quotes(cases.folder / "r/r.xml"));
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("2 criteria"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(test::read_text(cases.folder / "r/r.json")).size(), 2U);
    EXPECT_NE(test::read_text(cases.folder / "r/r.xml").find("failures=\"0\""), std::string::npos);
    EXPECT_TRUE(fs::exists(cases.folder / "scratch/mine/a/run.json"));
}

TEST(Verify, OneThatFailsIsExitThree) {
    const Outcome outcome = Cases(good + bad).verify("--jobs 3");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("1 FAILED"), std::string::npos) << outcome.out;
}

TEST(Verify, ACaseThatCannotBeReadIsExitTwo) {
    const Outcome outcome = Cases(good + "[[criterion]]\nid=\n").verify();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("case.toml:"), std::string::npos);
    EXPECT_EQ(Cases(good).verify("nosuchcase").code, 2);
    TempFolder empty;
    EXPECT_EQ(test::type21("verify --cases " + test::in_quotes(empty.path())).code, 2);
    EXPECT_EQ(test::type21("verify --cases /no/such/folder").code, 2);
}

TEST(Verify, ListRunsNothing) {
    const Cases cases(good);
    const Outcome outcome = cases.verify("--list");
    EXPECT_EQ(outcome.code, 0);
    EXPECT_NE(outcome.out.find("mine"), std::string::npos);
    EXPECT_FALSE(fs::exists(cases.folder / "scratch"));
}

TEST(Verify, ADeckThatMustBeRefused) {
    const Cases cases("[[criterion]]\nid=\"r\"\nrun=\"a\"\nkind=\"EXACT\"\nexpect_exit=2\nmessage=\"NOSUCHCARD\"\n");
    EXPECT_EQ(cases.verify().code, 3);  // a good deck is not refused
    const fs::path deck = cases.folder / "mine/flat_press_0000.rad";
    std::string text = test::read_text(deck);
    test::write_text(deck, text.replace(text.find("/IMPVEL"), 7, "/NOSUCHCARD"));
    EXPECT_EQ(cases.verify().code, 0);
}

}  // namespace
}  // namespace type21
