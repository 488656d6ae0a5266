#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/tests/cli/program.h"

namespace type21 {
namespace {

using test::Outcome;
using test::TempFolder;

TEST(BenchVerb, TimesADeckAndWritesJson) {
    TempFolder folder;
    const Outcome outcome =
        test::type21("bench " + test::in_quotes(test::cases() / "cylinder_slide/cylinder_slide_0000.rad") +
                     " --quick --check 2000 --json " + test::in_quotes(folder / "bench.json"));
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.err.find("45 nodes"), std::string::npos) << "progress: " << outcome.err;
    const auto json = nlohmann::json::parse(test::read_text(folder / "bench.json"));
    ASSERT_EQ(json["scenes"].size(), 1U) << "the deck is timed in place of the generated scenes";
    EXPECT_EQ(json["scenes"][0]["kind"], "deck");
    EXPECT_EQ(json["scenes"][0]["segments"], 144);
    EXPECT_EQ(json["check"]["different"], 0);
    EXPECT_GE(json["check"]["decisions"], 2000);
    EXPECT_NE(json["command"].get<std::string>().find("--check 2000"), std::string::npos);
    for (const auto& row : json["rows"])
        EXPECT_GT(row["ns"]["p50"].get<double>(), 0) << row;
}

TEST(BenchVerb, RefusesWhatItCannotMeasure) {
    for (const auto& [arguments, word] :
         std::initializer_list<std::pair<const char*, const char*>>{{"bench --sizes many", "'many' is not a count"},
                                                                    {"bench --sizes 20k,9M", "9M is outside 1k to 4M"},
                                                                    {"bench --nodes 1", "outside"},
                                                                    {"bench --threads 0", "--threads"},
                                                                    {"bench --check -1", "--check"},
                                                                    {"bench --wrong", "--wrong"}}) {
        const Outcome outcome = test::type21(arguments);
        EXPECT_EQ(outcome.code, 1) << arguments;
        EXPECT_NE(outcome.err.find(word), std::string::npos) << arguments << "\n" << outcome.err;
    }
    EXPECT_EQ(test::type21("bench no_such_deck_0000.rad").code, 2);
}

}  // namespace
}  // namespace type21
