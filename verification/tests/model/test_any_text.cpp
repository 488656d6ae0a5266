/// @file Decks as editors, transfers and accidents leave them: read correctly or refused, never a crash.
#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "driven_scene.h"
#include "reference/model/model.h"

namespace type21 {
namespace {

using namespace test;

/// What of a model does not depend on the look of the text.
void expect_same(const Model& a, const Model& b) {
    EXPECT_EQ(a.nodes.id, b.nodes.id);
    EXPECT_EQ(a.nodal_mass, b.nodal_mass);
    EXPECT_EQ(a.shells.size(), b.shells.size());
    EXPECT_EQ(a.imposed_motions.size(), b.imposed_motions.size());
    ASSERT_EQ(a.rigid_bodies.size(), b.rigid_bodies.size());
    EXPECT_EQ(a.rigid_bodies[0].mass, b.rigid_bodies[0].mass);
    EXPECT_EQ(a.interfaces.size(), b.interfaces.size());
}

std::string each_line(const std::string& text, const std::function<std::string(std::string)>& change) {
    std::string out;
    for (size_t at = 0; at < text.size();) {
        const size_t end = text.find('\n', at);
        out += change(text.substr(at, end - at)) + "\n";
        at = end + 1;
    }
    return out;
}

class SameText : public ::testing::TestWithParam<std::function<std::string(std::string)>> {};

TEST_P(SameText, GivesTheSameModel) {
    const Resolved plain = resolved(driven_scene());
    const Resolved other = resolved(each_line(driven_scene(), GetParam()));
    EXPECT_TRUE(other.problems.list().empty()) << all_of(other.problems);
    expect_same(plain.model, other.model);
}

/// Blanks that lead up to a field become tabs: a blank field of ten is one tab.
std::string with_tabs(std::string line) {
    const size_t tabs = line.starts_with(' ') ? line.find_first_not_of(' ') / 10 : 0;
    return std::string(tabs, '\t') + line.substr(10 * tabs);
}

std::string lower(std::string line) {
    if (!line.starts_with('/')) return line;
    for (char& c : line)
        c = static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
    return line;
}

INSTANTIATE_TEST_SUITE_P(Editors, SameText,
                         ::testing::Values([](std::string line) { return line + "\r"; },  // Windows
                                           [](std::string line) {
                                               return line + std::string(120 - std::min<size_t>(120, line.size()), ' ');
                                           },
                                           with_tabs,  // tabs
                                           lower, [](std::string line) { return "# comment\n$ comment\n" + line; }));

TEST(AnyText, CutAnywhereADeckIsRefusedOrReadButNeverCrashes) {
    const std::string text = driven_scene();
    int refused = 0;
    int cuts = 0;
    for (size_t length = 0; length < text.size() - 5; length += 97, ++cuts) {
        refused += resolved(text.substr(0, length)).problems.has_errors() ? 1 : 0;
    }
    EXPECT_GT(cuts, 20);
    EXPECT_EQ(refused, cuts) << "without /END a deck is not complete";
}

TEST(AnyText, WithOneLineLeftOutOrOneCharacterChangedItNeverCrashes) {
    const std::string text = driven_scene();
    int problems = 0;
    for (size_t at = 0; at < text.size(); at += 41) {
        const size_t begin = text.rfind('\n', at) == std::string::npos ? 0 : text.rfind('\n', at) + 1;
        std::string shorter = text;
        shorter.erase(begin, text.find('\n', at) - begin + 1);
        problems += static_cast<int>(resolved(shorter).problems.list().size());
        for (const char c : {'\x7F', '/', '9', '-', '\n'}) {
            std::string changed = text;
            changed[at] = c;
            problems += static_cast<int>(resolved(changed).problems.list().size());
        }
    }
    EXPECT_GT(problems, 100);
}

TEST(AnyText, AHundredThousandNodesAreRead) {
    std::string nodes = "/NODE\n";
    for (int i = 0; i < 100000; ++i)
        nodes += fmt::format("{:>10}{:>20}{:>20}{:>20}\n", 1000000000 + i, i, 0.5 * i, -i);
    const Resolved r = resolved(with_cards(nodes));
    EXPECT_TRUE(r.problems.list().empty()) << all_of(r.problems);
    ASSERT_EQ(r.model.nodes.size(), 100010);
    EXPECT_EQ(r.model.nodes.position[100009], Vec3(99999, 49999.5, -99999));
    EXPECT_EQ(r.model.nodes.index.at(1000099999), 100009);
}

TEST(AnyText, AHundredThousandWrongLinesGiveAHandfulOfMessages) {
    std::string nodes = "/NODE\n";
    for (int i = 0; i < 100000; ++i)
        nodes += fmt::format("{:>10}{:>20}\n", 1000 + i, "x" + std::to_string(i));
    const Resolved r = resolved(with_cards(nodes));
    EXPECT_LT(r.problems.list().size(), 30U);
    EXPECT_TRUE(r.problems.has_errors());
}

}  // namespace
}  // namespace type21
