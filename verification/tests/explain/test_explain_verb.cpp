// The verb: what it prints and with which exit code.
#include <array>
#include <cstdio>
#include <string>
#include <sys/wait.h>

#include <gtest/gtest.h>

namespace {

struct Outcome {
    int code;
    std::string text;  ///< stdout and stderr
};

Outcome type21(const std::string& arguments) {
    const std::string command = "cd '" TYPE21_SOURCE_DIR "' && '" TYPE21_BINARY "' explain " + arguments + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::string text;
    std::array<char, 4096> block{};
    for (size_t n; (n = fread(block.data(), 1, block.size(), pipe)) > 0;)
        text.append(block.data(), n);
    return {WEXITSTATUS(pclose(pipe)), text};
}

const std::string deck = "cases/cylinder_slide/cylinder_slide_0000.rad";

TEST(ExplainVerb, OfANode) {
    const Outcome good = type21(deck + " --node 1014 --time 4e-4");
    EXPECT_EQ(good.code, 0) << good.text;
    EXPECT_NE(good.text.find("retained impact"), std::string::npos);
    EXPECT_NE(good.text.find("manual page, equation (12)"), std::string::npos);
    EXPECT_NE(good.text.find("the force is that of the run, in every bit"), std::string::npos);
}

TEST(ExplainVerb, OfWhatIsNotThere) {
    for (const std::string& arguments :
         {deck + " --node 7777777 --time 0", deck + " --node 1014 --time 1", deck + " --node 90001 --time 0",
          std::string("missing_0000.rad --node 1 --time 0"), std::string("Depht")}) {
        const Outcome bad = type21(arguments);
        EXPECT_EQ(bad.code, 2) << arguments << "\n" << bad.text;
    }
    EXPECT_EQ(type21(deck + " --node 1014").code, 1) << "a time is needed";
    EXPECT_EQ(type21(deck).code, 1);
}

TEST(ExplainVerb, OfFieldsAndDepartures) {
    const Outcome field = type21("depth");
    EXPECT_EQ(field.code, 0);
    EXPECT_NE(field.text.find("line 2, columns 41 to 60"), std::string::npos);
    EXPECT_NE(field.text.find("depth_igap0"), std::string::npos) << "a case that covers it";
    const Outcome departure = type21("d03");
    EXPECT_EQ(departure.code, 0);
    EXPECT_NE(departure.text.find("DEPTH of the card is ignored for Igap 0"), std::string::npos);
}

TEST(ExplainVerb, OfTerms) {
    const Outcome term = type21("Kappa");
    EXPECT_EQ(term.code, 0);
    EXPECT_NE(term.text.find("Formulation 3, step 6 (reference/formulation/03_projection.md)"), std::string::npos);
    const Outcome both = type21("depth");
    EXPECT_LT(both.text.find("line 2, columns 41 to 60"), both.text.find("Formulation 2, step 8")) << "the field first";
    EXPECT_NE(both.text.find("Formulation 2, step 8"), std::string::npos);
    const Outcome near = type21("kapa");
    EXPECT_EQ(near.code, 2);
    EXPECT_NE(near.text.find("near it are: kappa"), std::string::npos) << near.text;
}

}  // namespace
