#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::DeckCopy;
using test::Outcome;
using test::TempFolder;
namespace fs = std::filesystem;

/// A result of flat_press, run once for all tests of this file.
const DeckCopy& flat_press() {
    static const DeckCopy deck("flat_press");
    static const Outcome outcome = test::type21("run " + test::in_quotes(deck.starter) +
                                                " --quiet --as-built all --out " + test::in_quotes(deck.out()));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return deck;
}

TEST(Compare, ARunAgreesWithItsCaseAndWithItself) {
    const std::string ours = test::in_quotes(flat_press().out());
    TempFolder folder;
    const Outcome outcome = test::type21("compare " + ours + " " + test::in_quotes(test::cases() / "flat_press") +
                                         " --json " + test::in_quotes(folder / "c.json"));
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_NE(outcome.out.find("tool.csv"), std::string::npos);
    EXPECT_EQ(nlohmann::json::parse(test::read_text(folder / "c.json"))["verdict"], "agree");
    EXPECT_EQ(test::type21("compare " + ours + " " + ours).code, 0);
}

TEST(Compare, ADifferenceIsExitThree) {
    const std::string ours = test::in_quotes(flat_press().out());
    TempFolder other;
    fs::copy(flat_press().out(), other.path(), fs::copy_options::recursive | fs::copy_options::overwrite_existing);
    std::string text = test::read_text(other / "interface_1.csv");
    const size_t mark = text.rfind('\n', text.size() - 2), row = text.rfind('\n', mark - 1);
    test::write_text(other / "interface_1.csv", text.erase(row, mark - row));  // the last row is gone
    const Outcome outcome = test::type21("compare " + test::in_quotes(other.path()) + " " + ours);
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("MISMATCH"), std::string::npos);
    EXPECT_EQ(test::type21("compare " + test::in_quotes(other.path()) + " " + ours + " --columns DX,DZ").code, 0);
}

TEST(Compare, TheTypeOfAgreementIsSaidWhenTheDeparturesAreOthers) {
    const DeckCopy deck("flat_press");
    ASSERT_EQ(
        test::type21("run " + test::in_quotes(deck.starter) + " --quiet --out " + test::in_quotes(deck.out())).code, 0);
    const Outcome outcome =
        test::type21("compare " + test::in_quotes(deck.out()) + " " + test::in_quotes(test::cases() / "flat_press"));
    EXPECT_EQ(outcome.code, 3);  // D25: impulses with another weight
    EXPECT_NE(outcome.out.find("--as-built"), std::string::npos);
    EXPECT_EQ(test::type21("compare " + test::in_quotes(deck.out()) + " " +
                           test::in_quotes(test::cases() / "flat_press") + " --tolerance 10")
                  .code,
              0);
}

TEST(Compare, NothingInCommonIsExitThree) {
    TempFolder a, b;
    const Outcome outcome = test::type21("compare " + test::in_quotes(a.path()) + " " + test::in_quotes(b.path()));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("Nothing in common"), std::string::npos);
}

}  // namespace
}  // namespace type21
