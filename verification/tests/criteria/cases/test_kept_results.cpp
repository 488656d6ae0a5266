// What has held is not run again, and whatever changes is.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/criteria/cases/digest.h"
#include "verification/criteria/cases/kept_results.h"
#include "verification/criteria/cases/verify_cases.h"
#include "verification/report/criteria_report.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

namespace fs = std::filesystem;
using test::read_text;
using test::TempFolder;
using test::write_text;

class KeptChecks : public testing::Test {
  protected:
    KeptChecks() {
        fs::create_directories(folder_ / "cases");
        for (const char* name : {"flat_press", "gapmin_default"})
            fs::copy(fs::path(TYPE21_SOURCE_DIR) / "cases" / name, folder_ / "cases" / name,
                     fs::copy_options::recursive);
    }

    /// Runs that were kept, of all.
    std::string verify(const std::string& with = "reference") {
        std::vector<std::string> problems;
        const auto cases = read_cases(folder_ / "cases", {}, problems);
        EXPECT_TRUE(problems.empty());
        size_t kept = 0;
        size_t all = 0;
        results_ = verify_cases(
            cases, folder_ / "scratch", 1,
            [&](const VerifyProgress& p) {
                ++all;
                if (p.kept) ++kept;
            },
            with, true);
        return fmt::format("{} of {}", kept, all);
    }

    fs::path file(const std::string& name) const { return folder_.path() / name; }

    TempFolder folder_;
    std::vector<CriterionResult> results_;
};

TEST_F(KeptChecks, AreTheSameRecords) {
    EXPECT_EQ(verify(), "0 of 4");
    auto first = criteria_json(results_);
    EXPECT_EQ(verify(), "4 of 4");
    const auto second = criteria_json(results_);
    ASSERT_EQ(first.size(), second.size());
    for (size_t i = 0; i < first.size(); ++i) {
        EXPECT_FALSE(first[i]["kept"]);
        first[i]["kept"] = true;
        EXPECT_EQ(first[i], second[i]);
    }
    EXPECT_NE(criteria_table(results_).find("4 runs were not repeated"), std::string::npos);
}

TEST_F(KeptChecks, BelongToTheCaseTheImplementationAndTheResults) {
    verify();
    const fs::path toml = file("cases/flat_press/case.toml");
    write_text(toml, read_text(toml) + "\n# a remark\n");
    EXPECT_EQ(verify(), "2 of 4");
    EXPECT_EQ(verify("optimized"), "0 of 4");
    EXPECT_EQ(verify("optimized"), "4 of 4");
    const fs::path result = file("scratch/flat_press/documented/nodes.csv");
    write_text(result, read_text(result) + " ");
    EXPECT_EQ(verify("optimized"), "3 of 4");
    fs::remove_all(file("scratch/flat_press/documented"));
    EXPECT_EQ(verify("optimized"), "3 of 4");
}

TEST_F(KeptChecks, AreNotKeptWhereOneFailed) {
    const fs::path measured = file("cases/flat_press/interface_1.csv");
    std::string text = read_text(measured);
    text.insert(text.rfind('\n', text.size() - 2) + 1, "9");
    write_text(measured, text);
    verify();
    EXPECT_EQ(verify(), "3 of 4");
}

TEST_F(KeptChecks, DamagedAreAsIfThereWereNone) {
    verify();
    const fs::path kept = file("scratch/gapmin_default/documented.criteria.json");
    ASSERT_TRUE(fs::exists(kept));
    write_text(kept, read_text(kept).substr(0, 100));
    EXPECT_EQ(verify(), "3 of 4");
    EXPECT_EQ(verify(), "4 of 4");
}

TEST(Digest, IsOfNamesAndBytes) {
    const TempFolder folder;
    write_text(folder / "a" / "one", "12");
    write_text(folder / "b" / "two", "12");
    write_text(folder / "c" / "one", "12");
    write_text(folder / "d" / "one", "1");
    EXPECT_EQ(digest_of(folder / "a"), digest_of(folder / "c"));
    EXPECT_NE(digest_of(folder / "a"), digest_of(folder / "b"));
    EXPECT_NE(digest_of(folder / "a"), digest_of(folder / "d"));
    EXPECT_EQ(digest_of(folder / "a" / "one"), digest_of(folder / "b" / "two"));
    EXPECT_NE(digest_of(folder / "a" / "one"), digest_of(folder / "d" / "one"));
    EXPECT_THROW(digest_of(folder / "none"), std::runtime_error);
}

}  // namespace
}  // namespace type21
