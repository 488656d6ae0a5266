#include <cmath>

#include <gtest/gtest.h>

#include "reference/contract/origin.h"
#include "reference/model/card_reader.h"
#include "reference/model/numbers.h"
#include "verification/tests/deck/problem_search.h"

namespace type21 {
namespace {

/// A card of these data lines, read from Mg mm s into SI.
class CardReaderTest : public ::testing::Test {
  protected:
    CardReader& read(std::vector<std::string> lines) {
        texts_ = std::move(lines);
        deck_.files = {"scene_0000.rad"};
        card_.keyword = "/CARD/1";
        card_.place = {"/CARD/1", 0, 10};
        card_.lines.clear();
        for (size_t i = 0; i < texts_.size(); ++i) {
            card_.lines.push_back({texts_[i], 0, 11 + static_cast<int>(i)});
        }
        reader_.emplace(deck_, card_, from_, to_, problems);
        return *reader_;
    }
    Problem first() const { return problems.list().empty() ? Problem{} : problems.list().front(); }

    Problems problems;

  private:
    std::vector<std::string> texts_;
    UnitSystem from_{1e3, 1e-3, 1, "Mg", "mm", "s"};
    UnitSystem to_;
    Deck deck_;
    Card card_;
    std::optional<CardReader> reader_;
};

TEST_F(CardReaderTest, FieldsByColumn) {
    CardReader& r = read({"        12        -7                 1.5"});
    EXPECT_EQ(r.integer(0, 1, 10, "A"), 12);
    EXPECT_EQ(r.integer(0, 11, 20, "B"), -7);
    EXPECT_EQ(r.real_as_written(0, 21, 40, "C"), 1.5);
    EXPECT_DOUBLE_EQ(r.real(0, 21, 40, "C", dim::length), 0.0015);
    EXPECT_EQ(r.text(0, 21, 40), "1.5");
    EXPECT_TRUE(problems.list().empty());
}

TEST_F(CardReaderTest, BlankColumnsAndMissingLinesAreZero) {
    CardReader& r = read({"         1"});
    EXPECT_EQ(r.integer(0, 11, 20, "A"), 0);
    EXPECT_EQ(r.real(3, 1, 20, "B", dim::length), 0);
    EXPECT_TRUE(r.blank(0, 11, 20));
    EXPECT_TRUE(r.blank(9, 1, 10));
    EXPECT_FALSE(r.blank(0, 1, 10));
    EXPECT_EQ(r.line_number(0), 11);
    EXPECT_EQ(r.line_number(5), 10);
    EXPECT_TRUE(problems.list().empty());
}

TEST_F(CardReaderTest, IdsOfTenDigitsSideBySide) {
    CardReader& r = read({"10000000019999999999-100000000"});
    EXPECT_EQ(r.integer(0, 1, 10, "A"), 1000000001);
    EXPECT_EQ(r.integer(0, 11, 20, "B"), 9999999999);
    EXPECT_EQ(r.integer(0, 21, 30, "C"), -100000000);
    EXPECT_TRUE(problems.list().empty());
}

TEST_F(CardReaderTest, AWordThatIsNotANumberIsAnErrorAndReadsAsZero) {
    CardReader& r = read({"       abc     1 2  "});
    EXPECT_EQ(r.integer(0, 1, 10, "N"), 0);
    EXPECT_EQ(first().value, "abc");
    EXPECT_EQ(first().field, "N");
    EXPECT_EQ(first().card, "/CARD/1");
    EXPECT_EQ(first().place.line, 11);
    EXPECT_FALSE(first().remedy.empty());
    EXPECT_EQ(r.integer(0, 11, 20, "M"), 0);
    EXPECT_EQ(r.real(0, 1, 10, "X", dim::length), 0);
    EXPECT_EQ(problems.error_count(), 3);
}

TEST_F(CardReaderTest, ARealInAnIntegerFieldAndAnIntegerOutOfRange) {
    CardReader& r = read({"       1.0       1e3", "          99999999999999999999"});
    EXPECT_EQ(r.integer(0, 1, 10, "A"), 0);
    EXPECT_NE(first().rule.find("integer"), std::string::npos);
    EXPECT_NE(first().remedy.find("decimal point"), std::string::npos);
    EXPECT_EQ(r.integer(0, 11, 20, "B"), 0);
    EXPECT_EQ(r.integer(1, 11, 30, "C"), 0);
    ASSERT_EQ(problems.error_count(), 3);
    EXPECT_NE(problems.list()[2].rule.find("64 bits"), std::string::npos);
}

TEST_F(CardReaderTest, RealsOutOfRange) {
    CardReader& r = read({"               1e400              1e-400               1e308"});
    EXPECT_EQ(r.real(0, 1, 20, "A", dim::none), 0);
    EXPECT_EQ(r.real(0, 21, 40, "B", dim::none), 0);
    EXPECT_EQ(r.real(0, 41, 60, "C", dim::mass), 0) << "1e308 Mg is not finite in kg";
    EXPECT_EQ(problems.error_count(), 3);
}

TEST_F(CardReaderTest, AWordCutByTheBorderIsAWarning) {
    CardReader& r = read({"         1001      1002", "      1001 12345678901.5"});
    EXPECT_EQ(r.integer(0, 1, 10, "A"), 1);
    ASSERT_EQ(problems.warning_count(), 1);
    EXPECT_EQ(first().value, "1001");
    EXPECT_NE(first().rule.find("column 10"), std::string::npos);
    EXPECT_EQ(r.integer(1, 1, 10, "B"), 1001);
    EXPECT_EQ(problems.list().size(), 1U);
    EXPECT_FALSE(problems.has_errors());
}

TEST_F(CardReaderTest, NumbersThatNoOneAskedForAreAWarning) {
    CardReader& r = read({"title 7", "         1         2                 3.5", "         4"});
    EXPECT_EQ(r.integer(1, 1, 10, "A"), 1);
    EXPECT_EQ(r.integer(2, 1, 10, "B"), 4);
    r.finish();
    ASSERT_EQ(problems.list().size(), 1U);
    EXPECT_EQ(first().severity, Severity::warning);
    EXPECT_EQ(first().field, "columns 11 to 100");
    EXPECT_EQ(first().value, "2                 3.5");
    EXPECT_EQ(first().place.line, 12);
}

TEST_F(CardReaderTest, ZerosBlanksAndRemarksThereAreSilent) {
    CardReader& r = read({"title", "         1         0                 0.0", "         2  # of 3", "         3"});
    for (size_t line = 1; line < 4; ++line)
        r.integer(line, 1, 10, "A");
    r.finish();
    EXPECT_TRUE(problems.list().empty());
}

TEST_F(CardReaderTest, WhatIsNoNumberThereIsAnError) {
    for (const char* word : {"NaN", "0x1", "--1", "1,5", "1.5+3", "1e4x", "inf"}) {
        problems = {};
        CardReader& r = read({"title", std::string("         1    ") + word});
        r.integer(1, 1, 10, "A");
        r.finish();
        ASSERT_EQ(problems.error_count(), 1) << word;
        EXPECT_EQ(first().value, word);
        problems = {};
        CardReader& declared = read({"title", std::string("         1    ") + word});
        declared.integer(1, 1, 10, "A");
        declared.unused(1, 11, 20, 10);
        declared.finish();
        ASSERT_EQ(problems.error_count(), 1) << word;
        EXPECT_EQ(first().field, "columns 11 to 20") << word;
    }
}

TEST_F(CardReaderTest, AnUnusedFieldMayHoldAnyNumber) {
    CardReader& r = read({"title", "         1        24     1e400                         5"});
    r.integer(1, 1, 10, "A");
    r.unused(1, 11, 60, 10);
    r.finish();
    EXPECT_TRUE(problems.list().empty());
}

TEST_F(CardReaderTest, WhatStandsBeyondTheCardIsSaidOnce) {
    CardReader& r = read({"title", "         1" + std::string(95, ' ') + "7", "  10000001 2"});
    r.integer(1, 1, 10, "A");
    r.integer(2, 1, 9, "B");
    r.finish();
    ASSERT_EQ(problems.list().size(), 3U);
    EXPECT_NE(problems.list()[0].rule.find("border"), std::string::npos);
    EXPECT_EQ(problems.list()[1].field, "columns beyond 100");
    EXPECT_EQ(problems.list()[2].value, "2") << "the word that is cut has had its message";
}

TEST_F(CardReaderTest, AControlCharacterOfATextIsWrittenOut) {
    EXPECT_EQ(read({"a\x1b[31mb"}).text(0, 1, 100), "a\\x1b[31mb");
}

TEST(Numbers, Reals) {
    double value = 0;
    for (const auto& [word, expected] : {std::pair<const char*, double>{"1.0D+3", 1000},
                                         {"1.5d-3", 0.0015},
                                         {"+2", 2},
                                         {"-.5", -0.5},
                                         {"3.", 3},
                                         {"1E2", 100}}) {
        EXPECT_EQ(parse_real(word, value), NumberFault::none) << word;
        EXPECT_DOUBLE_EQ(value, expected) << word;
    }
    for (const char* word : {"", "nan", "NaN", "inf", "-inf", "infinity", "0x10", "1.5.2", "1e", "--1", "+-1", "1,5"}) {
        EXPECT_EQ(parse_real(word, value), NumberFault::not_a_number) << word;
    }
    EXPECT_EQ(parse_real("1e400", value), NumberFault::out_of_range);
}

TEST(Origins, Text) {
    EXPECT_EQ(to_text(Origin{Origin::Kind::deck, 41, ""}), "line 41");
    EXPECT_EQ(to_text(Origin{Origin::Kind::fallback, 0, "0 means 1"}), "default: 0 means 1");
    EXPECT_EQ(to_text(Origin{Origin::Kind::rule, 41, "raised to the largest gap"}),
              "rule (line 41): raised to the largest gap");
    EXPECT_EQ(to_text(Origin{}), "not in this version");
}

}  // namespace
}  // namespace type21
