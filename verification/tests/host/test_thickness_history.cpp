// The table of thickness against time: what it gives, and every way in which it can be wrong.
#include <gtest/gtest.h>

#include "reference/host/thickness_history.h"
#include "verification/tests/deck/problem_search.h"

namespace type21 {
namespace {

using test::all_of;
using test::TempFolder;

/// Shells 11, 12, 13 of 1.0, 1.1, 1.2 mm.
Model three_shells() {
    Model model;
    for (int i = 0; i < 3; ++i) {
        Shell shell;
        shell.id = 11 + i;
        shell.thickness = 1.0 + 0.1 * i;
        model.shells.push_back(shell);
    }
    return model;
}

struct Read {
    ThicknessHistory history;
    Problems problems;
};

Read read(const std::string& text, const Model& model = three_shells()) {
    const TempFolder folder;
    Read result;
    result.history = ThicknessHistory::read(folder.write("thickness.csv", text), model, result.problems);
    return result;
}

std::vector<double> at(const ThicknessHistory& history, double time) {
    std::vector<double> thickness{1.0, 1.1, 1.2};
    history.at(time, thickness);
    return thickness;
}

const std::string table = "time,13,11\n0.0,1.2,1.0\n1e-6,1.4,0.5\n3e-6,2.0,0.0\n";

TEST(ThicknessHistory, GivesEachColumnToItsShell) {
    const Read r = read(table);
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(r.history.shells(), (std::vector<int>{2, 0}));
    EXPECT_EQ(r.history.times(), (std::vector<double>{0, 1e-6, 3e-6}));
    EXPECT_EQ(at(r.history, 1e-6), (std::vector<double>{0.5, 1.1, 1.4})) << "shell 12 has no column and keeps its own";
}

TEST(ThicknessHistory, IsLinearBetweenRows) {
    const ThicknessHistory history = read(table).history;
    const std::vector<double> half = at(history, 2e-6);
    EXPECT_DOUBLE_EQ(half[0], 0.25);
    EXPECT_DOUBLE_EQ(half[2], 1.7);
    EXPECT_DOUBLE_EQ(at(history, 0.25e-6)[0], 0.875);
}

TEST(ThicknessHistory, IsConstantBeyondBothEnds) {
    const ThicknessHistory history = read(table).history;
    EXPECT_EQ(at(history, -1), (std::vector<double>{1.0, 1.1, 1.2}));
    EXPECT_EQ(at(history, 1), (std::vector<double>{0.0, 1.1, 2.0})) << "0: the element is deleted";
}

TEST(ThicknessHistory, ATimeNearARowIsThatRowToTheLastBit) {
    // A sum of steps misses a printed time by rounding: within 1e-6 of the spacing it counts as that row.
    const ThicknessHistory history = read(table).history;
    for (const double time : {1e-6 - 0.9e-12, 1e-6, 1e-6 + 1.9e-12})
        EXPECT_EQ(at(history, time)[0], 0.5) << time;
    EXPECT_NE(at(history, 1e-6 - 1.1e-12)[0], 0.5);
    EXPECT_NE(at(history, 1e-6 + 2.1e-12)[0], 0.5) << "the spacing behind it is twice as wide";
    EXPECT_EQ(at(history, 3e-6 - 1.9e-12)[0], 0.0);
}

TEST(ThicknessHistory, OfOneRowIsConstant) {
    const Read r = read("time,12\n5.0,3.0\n");
    EXPECT_TRUE(r.problems.list().empty());
    for (const double time : {0.0, 5.0, 9.0})
        EXPECT_EQ(at(r.history, time), (std::vector<double>{1.0, 3.0, 1.2}));
}

TEST(ThicknessHistory, ReadsWhatAWindowsEditorLeft) {
    const Read r = read("time, 11 ,12\r\n0.0, 1.5 ,2.5\r\n\r\n1.0,1.0D0,2\r\n\r\n");
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    EXPECT_EQ(at(r.history, 0.0), (std::vector<double>{1.5, 2.5, 1.2}));
    EXPECT_EQ(at(r.history, 1.0), (std::vector<double>{1.0, 2.0, 1.2}));
}

Problem only(const std::string& text, const Model& model = three_shells()) {
    const Read r = read(text, model);
    EXPECT_EQ(r.problems.list().size(), 1u) << text << all_of(r.problems);
    EXPECT_EQ(r.problems.error_count(), 1);
    return r.problems.list().empty() ? Problem{} : r.problems.list().front();
}

TEST(ThicknessHistory, MistakesHaveTheirLine) {
    const auto expect = [](const std::string& text, int line, const std::string& value, const std::string& words) {
        const Problem p = only(text);
        EXPECT_EQ(p.place.line, line) << text;
        EXPECT_EQ(p.value, value);
        EXPECT_NE(p.rule.find(words), std::string::npos) << p.rule;
        EXPECT_FALSE(p.remedy.empty());
        EXPECT_NE(p.place.file.find("thickness.csv"), std::string::npos);
    };
    expect("time,11,99\n0,1,1\n", 1, "99", "no shell");
    expect("time,11,x\n0,1,1\n", 1, "x", "no shell");
    expect("time,11,11\n0,1,1\n", 1, "11", "a column already");
    expect("t,11\n0,1\n", 1, "t", "first line");
    expect("time\n0\n", 1, "", "no column");
    expect("time,11\n0,1\n1,1\n1,1\n", 4, "1", "ascend");
    expect("time,11\n2,1\n1,1\n3,1\n", 3, "1", "ascend");
    expect("time,11\n0,-0.1\n", 2, "-0.1", "not negative");
    expect("time,11\n0,1\n1,abc\n", 3, "abc", "not a number");
    expect("time,11\n0,1\n1,nan\n", 3, "nan", "not a number");
    expect("time,11\n0,1\n1,\n", 3, "", "not a number");
    expect("time,11\nx,1\n", 2, "x", "not a number");
    expect("time,11\n0,1,2\n", 2, "3 values", "2 values");
    expect("time,11\n0\n", 2, "1 values", "2 values");
    expect("time,11\n", 0, "", "no row");
    expect("", 0, "", "empty");
}

TEST(ThicknessHistory, AllMistakesAreReportedAtOnce) {
    EXPECT_EQ(read("time,11,99\n0,1,1\n0,-1,x\n1\n").problems.error_count(), 4);
}

TEST(ThicknessHistory, AQuadAndATriangleWithOneIdAreToldApartByNobody) {
    Model model = three_shells();
    model.shells[2].id = 11;
    EXPECT_NE(only("time,11\n0,1\n", model).rule.find("share this id"), std::string::npos);
    EXPECT_TRUE(read("time,12\n0,1\n", model).problems.list().empty());
}

TEST(ThicknessHistory, AMissingOrBinaryFileIsAnError) {
    Problems problems;
    const ThicknessHistory none = ThicknessHistory::read("no/such/file.csv", three_shells(), problems);
    ASSERT_EQ(problems.error_count(), 1);
    EXPECT_EQ(problems.list()[0].value, "no/such/file.csv");
    EXPECT_EQ(at(none, 0), (std::vector<double>{1.0, 1.1, 1.2})) << "nothing changes";
    EXPECT_EQ(read(std::string("time,11\n0,1\0\n", 13)).problems.error_count(), 1);
}

}  // namespace
}  // namespace type21
