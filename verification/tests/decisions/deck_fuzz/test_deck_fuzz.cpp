// The fuzzer of the deck reader in short, with any compiler: what it once found, the cases, and changed cases.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "verification/decisions/deck_fuzz/deck_input.h"
#include "verification/decisions/deck_fuzz/deck_mutator.h"

namespace type21::fuzz {
namespace {

namespace fs = std::filesystem;

std::string bytes_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

/// Starter and engine deck of every case as one input, by name.
std::vector<std::string> case_inputs() {
    std::vector<fs::path> starters;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(TYPE21_SOURCE_DIR) / "cases"))
        if (entry.path().string().ends_with("_0000.rad")) starters.push_back(entry.path());
    std::sort(starters.begin(), starters.end());
    std::vector<std::string> inputs;
    for (const fs::path& starter : starters) {
        std::string engine = starter.string();
        engine[engine.size() - 5] = '1';
        inputs.push_back(bytes_of(starter) + "//// fuzz_0001.rad\n" + bytes_of(engine));
    }
    return inputs;
}

TEST(DeckFuzz, AnInputIsSplitIntoItsFiles) {
    const auto files = deck_files("/BEGIN\n#include a.inc\n//// a.inc\n/NODE\n//// fuzz_0001.rad\r\n/RUN/x/1\n1.0");
    ASSERT_EQ(files.size(), 3U);
    EXPECT_EQ(files[0].path, "fuzz_0000.rad");
    EXPECT_EQ(files[0].bytes, "/BEGIN\n#include a.inc\n");
    EXPECT_EQ(files[1].path, "a.inc");
    EXPECT_EQ(files[1].bytes, "/NODE\n");
    EXPECT_EQ(files[2].path, "fuzz_0001.rad");
    EXPECT_EQ(files[2].bytes, "/RUN/x/1\n1.0");
    EXPECT_EQ(deck_files("").size(), 1U);
}

TEST(DeckFuzz, FindingsStayMended) {
    for (const auto& entry :
         fs::directory_iterator(fs::path(TYPE21_SOURCE_DIR) / "verification/tests/deck/fuzz_findings")) {
        if (entry.path().extension() != ".deck") continue;
        SCOPED_TRACE(entry.path().string());
        const std::string text = bytes_of(entry.path());
        EXPECT_NO_THROW(read_and_resolve(text, AsBuilt()));
        EXPECT_NO_THROW(read_and_resolve(text, AsBuilt::all()));
    }
}

// The seeds are of use only if the reader accepts them, as documented or as built (filter2 is accepted as built only).
TEST(DeckFuzz, TheCasesAreAcceptedFromMemory) {
    const auto inputs = case_inputs();
    ASSERT_GE(inputs.size(), 50U);
    for (const std::string& input : inputs) {
        EXPECT_TRUE(read_and_resolve(input, AsBuilt()).accepted || read_and_resolve(input, AsBuilt::all()).accepted)
            << input.substr(0, 300);
    }
}

TEST(DeckFuzz, ChangedCasesAreReadOrRefused) {
    const auto inputs = case_inputs();
    int accepted = 0;
    int refused = 0;
    for (std::uint32_t seed = 0; seed < 300; ++seed) {
        const std::string text = mutated(inputs[seed % inputs.size()], seed);
        EXPECT_EQ(text, mutated(inputs[seed % inputs.size()], seed)) << "a seed must give one input";
        const auto departures = seed % 2 == 0 ? AsBuilt() : AsBuilt::all();
        EXPECT_NO_THROW((read_and_resolve(text, departures).accepted ? accepted : refused) += 1) << "seed " << seed;
    }
    // Both happen, else only one half of the reader is tried.
    EXPECT_GT(accepted, 30);
    EXPECT_GT(refused, 30);
}

}  // namespace
}  // namespace type21::fuzz
