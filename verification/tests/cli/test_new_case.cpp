/// @file A new case needs one folder and no code: the one that cases/README.md shows.
#include <gtest/gtest.h>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::Outcome;
using test::TempFolder;
namespace fs = std::filesystem;

/// The case.toml in cases/README.md.
std::string shown_in_readme() {
    const std::string text = test::read_text(fs::path(TYPE21_SOURCE_DIR) / "cases/README.md");
    const std::string opening = "```toml\n";
    const size_t begin = text.find(opening);
    if (begin == std::string::npos) throw std::runtime_error("cases/README.md shows no case.toml");
    return text.substr(begin + opening.size(), text.find("```", begin + 3) - begin - opening.size());
}

/// A folder of cases that holds the one of cases/README.md and nothing else.
struct MyCase {
    TempFolder cases;

    explicit MyCase(const std::string& toml) {
        for (const char* ending : {"_0000.rad", "_0001.rad"}) {
            fs::create_directories(cases / "my_press");
            fs::copy_file(test::cases() / "patch_signature" / (std::string("patch_signature") + ending),
                          cases / (std::string("my_press/my_press") + ending));
        }
        test::write_text(cases / "my_press/case.toml", toml);
    }
    Outcome verify(const std::string& with = "reference") const {
        return test::type21("verify my_press --cases " + test::in_quotes(cases.path()) + " --scratch " +
                            test::in_quotes(cases / "scratch") + " --with " + with);
    }
};

TEST(NewCase, TheFolderOfTheReadmeIsOneForBothImplementations) {
    const MyCase mine(shown_in_readme());
    for (const char* with : {"reference", "optimized"}) {
        const Outcome outcome = mine.verify(with);
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
        EXPECT_NE(outcome.out.find("1 criterion (1 ANALYTIC) of 1 run in 1 case: all hold"), std::string::npos)
            << outcome.out;
    }
}

TEST(NewCase, ANumberThatDoesNotHoldIsExitThree) {
    std::string toml = shown_in_readme();
    const std::string expected = "-40.36724567413330";
    const size_t at = toml.find(expected);
    ASSERT_NE(at, std::string::npos);
    const Outcome outcome = MyCase(toml.replace(at, expected.size(), "-40.36724567423330")).verify();
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("1 FAILED"), std::string::npos) << outcome.out;
}

TEST(NewCase, AKeyThatIsNoneIsExitTwo) {
    const Outcome outcome = MyCase(shown_in_readme() + "tolerence = 1\n").verify();
    EXPECT_EQ(outcome.code, 2);
    EXPECT_NE(outcome.err.find("tolerence"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace type21
