#include <gtest/gtest.h>

#include "verification/support/json_file.h"
#include "verification/support/json_reader.h"
#include "verification/support/nearest_word.h"
#include "verification/support/shown_text.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

/// The one message about a text; empty when it is read.
std::string message(const std::string& text) {
    std::vector<std::string> problems;
    const auto json = parse_json(text, "f.json", problems);
    EXPECT_EQ(json.has_value(), problems.empty());
    EXPECT_LE(problems.size(), 1U);
    return problems.empty() ? "" : problems[0];
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

TEST(JsonFile, ReadsWhatItShould) {
    EXPECT_EQ(message(R"({"a": [1, 2.5, "x", null, true, {"b": []}]})"), "");
    EXPECT_EQ(message("\xEF\xBB\xBF{\"a\": 1}"), "") << "a byte-order mark of UTF-8";
    EXPECT_EQ(message("{\"a\": 1e-400}"), "") << "nothing is nearest to it";
}

TEST(JsonFile, ANumberBeyondADoubleIsNamedWithItsPlace) {
    EXPECT_EQ(message(R"({"blocks":[{"nodes":[[1e400,0,0]]}]})"),
              "f.json: /blocks/0/nodes/0/0: '1e400' is too large for a double");
    EXPECT_TRUE(has(message(R"({"a": 1, "b": -2e308})"), "/b: '-2e308'"));
    const std::string many(100000, '9');
    EXPECT_LT(message("[1, " + many + "]").size(), 200U) << "what is quoted is bounded";
}

TEST(JsonFile, SyntaxIsNamedWithLineColumnAndPlace) {
    const std::string nan = message("{\"a\": 1,\n \"b\": [0, NaN]}");
    EXPECT_TRUE(nan.starts_with("f.json:2:")) << nan;
    EXPECT_TRUE(has(nan, "/b/1: is not JSON")) << nan;
    for (const char* text : {"", "{", "[1,]", "{\"a\" 1}", "{\"a\": Infinity}", "[1] [2]", "{} x", "'a'", "[01]",
                             "{\"a\": }", "\"\\x\"", "[\"\x80\"]", "// c\n[]", "nul"})
        EXPECT_TRUE(has(message(text), "is not JSON")) << text;
    EXPECT_LT(message("\"" + std::string(100000, 'a')).size(), 400U);
    EXPECT_EQ(message("[\"\x1b[31m").find('\x1b'), std::string::npos) << "no byte that a terminal obeys";
}

TEST(JsonFile, DepthIsBounded) {
    const auto nested = [](int levels) {
        return std::string(static_cast<size_t>(levels), '[') + std::string(static_cast<size_t>(levels), ']');
    };
    EXPECT_EQ(message(nested(deepest_json)), "");
    EXPECT_TRUE(has(message(nested(deepest_json + 1)), "more than 64 lists and objects inside each other"));
    EXPECT_LT(message(R"({"a": )" + nested(1000000) + "}").size(), 300U);
    std::string objects;
    for (int i = 0; i < 100000; ++i)
        objects += "{\"k\":";
    EXPECT_TRUE(has(message(objects), "inside each other"));
}

TEST(JsonFile, AKeyTwiceIsAnError) {
    EXPECT_EQ(message(R"({"a": [{"b": 1, "c": 2, "b": 3}]})"), "f.json: /a/0/b: the key is there twice");
    EXPECT_EQ(message(R"({"a": {"x": 1}, "b": {"x": 1}})"), "");
}

TEST(JsonFile, AnotherEncodingIsNamed) {
    EXPECT_TRUE(has(message(std::string("\xFF\xFE{\0}\0", 6)), "is UTF-16"));
    EXPECT_TRUE(has(message(std::string("\xFE\xFF\0{\0}", 6)), "is UTF-16"));
    EXPECT_TRUE(has(message(std::string("{\0}\0", 4)), "is UTF-16"));
}

TEST(JsonFile, WhatCannotBeReadIsSaid) {
    test::TempFolder folder;
    std::vector<std::string> problems;
    EXPECT_FALSE(read_json(folder / "none.json", problems));
    EXPECT_FALSE(read_json(folder.path(), problems));
    EXPECT_FALSE(read_json("/dev/zero", problems));
    ASSERT_EQ(problems.size(), 3U);
    EXPECT_TRUE(has(problems[0], "cannot be read"));
    EXPECT_TRUE(has(problems[1], "cannot be read"));
}

TEST(JsonReader, CountsWhatItDoesNotSay) {
    std::vector<std::string> problems;
    {
        JsonReader reader("f", problems);
        for (int i = 0; i < 5000; ++i)
            reader.number("x", json_place("/list", static_cast<size_t>(i)));
        EXPECT_FALSE(reader.ok());
    }
    ASSERT_EQ(problems.size(), most_complaints + 1);
    EXPECT_EQ(problems.back(), "f: 4900 more problems");
}

TEST(JsonReader, ANumberIsFiniteAndNothingElse) {
    std::vector<std::string> problems;
    JsonReader reader("f", problems);
    EXPECT_EQ(reader.number("0x1.8p+1", "/a"), 3.0);
    EXPECT_EQ(reader.number(7, "/a"), 7.0);
    EXPECT_TRUE(problems.empty());
    using Json = nlohmann::json;
    const std::vector<Json> wrong{" 1",    "1 ", "nan",         "inf",         "0x", "1,5", std::string("1\0", 2),
                                  nullptr, true, Json::array(), Json::object()};
    for (const Json& one : wrong)
        reader.number(one, "/a");
    EXPECT_EQ(problems.size(), wrong.size());
}

TEST(ShownText, IsShortAndHarmless) {
    EXPECT_EQ(shown("a\x1b[31mb"), "a\\x1b[31mb");
    EXPECT_EQ(shown("\xC3\xBC\xE2\x82\xAC"), "\xC3\xBC\xE2\x82\xAC") << "u umlaut, euro";
    EXPECT_EQ(shown("\xFC"), "\\xfc") << "Latin-1";
    EXPECT_EQ(shown("\xC2\x9B"), "\\xc2\\x9b") << "a control character of C1";
    EXPECT_EQ(shown("\xED\xA0\x80"), "\\xed\\xa0\\x80") << "half of a pair of UTF-16";
    EXPECT_EQ(shown(std::string(100, 'x')), std::string(60, 'x') + "...");
    EXPECT_EQ(shown("abc", 3), "abc");
}

TEST(NearestWord, IsNearOrNone) {
    const std::vector<std::string_view> words{"gap", "depth", "reach", "p"};
    EXPECT_EQ(nearest_word("Dept", words), "depth");
    EXPECT_EQ(nearest_word("GAP", words), "gap");
    EXPECT_EQ(nearest_word("rech", words), "reach");
    EXPECT_EQ(nearest_word("velocity", words), "");
}

}  // namespace
}  // namespace type21
