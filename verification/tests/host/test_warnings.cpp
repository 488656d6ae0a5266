// Each warning: a deck that shows it, what the message names, and decks near to it that must stay silent.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "press_deck.h"

namespace type21 {
namespace {

using namespace test;

/// The only warning of a deck.
Problem the_warning(const PressDeck& press) {
    const Problems warnings = warnings_of(press);
    EXPECT_EQ(warnings.list().size(), 1U) << all_of(warnings);
    return warnings.list().empty() ? Problem{} : warnings.list().front();
}

void expect_silent(const PressDeck& press) {
    const Problems warnings = warnings_of(press);
    EXPECT_TRUE(warnings.list().empty()) << all_of(warnings);
}

#define EXPECT_SAYS(text, part) EXPECT_NE((text).find(part), std::string::npos) << (text)

TEST(Warnings, NoneOfAPlainPress) {
    expect_silent({});
}

TEST(TurnedSegments, AreNamedWithTheirNodesWhateverTheirNumber) {
    PressDeck one;
    one.turned = {4};
    Problem problem = the_warning(one);
    EXPECT_EQ(problem.field, "surf_IDm");
    EXPECT_SAYS(problem.value, "1 of 9 segments: no. 5; the first has the nodes 106, 107, 111, 110");
    EXPECT_SAYS(problem.rule, "4 shared edges");
    EXPECT_EQ(problem.place.file, "press_0000.rad");
    EXPECT_GT(problem.place.line, 0);

    PressDeck row;
    row.turned = {0, 1, 2};
    problem = the_warning(row);
    EXPECT_SAYS(problem.value, "3 of 9 segments: no. 1, 2, 3;");
    EXPECT_SAYS(problem.rule, "3 shared edges");
}

TEST(TurnedSegments, AreTheFewerOnes) {
    PressDeck most;
    most.turned = {0, 1, 2, 3, 5, 6, 7, 8};
    EXPECT_SAYS(the_warning(most).value, "1 of 9 segments: no. 5;");
}

TEST(TurnedSegments, AWholeToolThatIsTurnedHasAnotherWarning) {
    PressDeck all;
    all.turned = {0, 1, 2, 3, 4, 5, 6, 7, 8};
    expect_silent(all);
}

TEST(TurnedSegments, SegmentsApartMayLookWhereTheyLike) {
    PressDeck apart;
    apart.more_nodes =
        "       401               100.0                 0.0                 2.0\n"
        "       402               112.0                 0.0                 2.0\n"
        "       403               112.0                12.0                 2.0\n"
        "       404               100.0                12.0                 2.0\n";
    apart.more_shells = "       401       401       402       403       404\n";
    expect_silent(apart);
}

TEST(OpenSeams, ANodeOfItsOwnAtEachPlaceOfASeam) {
    PressDeck press;
    press.unmerged = true;
    const Problem problem = the_warning(press);
    EXPECT_EQ(problem.field, "surf_IDm");
    EXPECT_SAYS(problem.value, "4 pairs of nodes, the first 103 and 301");
    EXPECT_SAYS(problem.rule, "0.012 mm");
}

TEST(OpenSeams, NodesThatAreApartAreTwoSheets) {
    PressDeck press;  // a sheet beside the tool, 0.1 mm from its border
    press.more_nodes =
        "       401                28.1                -8.0                 2.0\n"
        "       402                28.1                 4.0                 2.0\n"
        "       403                40.1                 4.0                 2.0\n"
        "       404                40.1                -8.0                 2.0\n";
    press.more_shells = "       401       401       402       403       404\n";
    expect_silent(press);
    // ... and 5 micrometres from it
    press.more_nodes = replaced(replaced(press.more_nodes, "  28.1", "28.005"), "  28.1", "28.005");
    EXPECT_SAYS(the_warning(press).value, "2 pairs of nodes");
}

/// A second face of the tool, this far above the first, that looks up.
PressDeck with_back(double thickness) {
    PressDeck press;
    press.more_nodes = fmt::format(
        "       401                -8.0                -8.0{0:>20}\n"
        "       402                28.0                -8.0{0:>20}\n"
        "       403                28.0                28.0{0:>20}\n"
        "       404                -8.0                28.0{0:>20}\n",
        2.0 + thickness);
    press.more_shells = "       401       401       402       403       404\n";
    return press;
}

TEST(ThinTools, TwoFacesNearerThanDepth) {
    PressDeck press = with_back(1.5);
    press.depth = "3.0";
    const Problem problem = the_warning(press);
    EXPECT_EQ(problem.field, "DEPTH");
    EXPECT_EQ(problem.value, "3 mm");
    EXPECT_SAYS(problem.rule, "only 1.5 mm thick at segment 1 ");
    // All nine segments below, and the one above: the middle of the tool is below its middle.
    EXPECT_SAYS(problem.rule, "10 segments");
}

TEST(ThinTools, AThickerToolOrASlotIsNone) {
    PressDeck thick = with_back(4.0);
    thick.depth = "3.0";
    expect_silent(thick);
    PressDeck slot = with_back(-1.5);  // the two faces look at each other
    slot.more_shells = "       401       401       402       403       404\n";
    slot.depth = "3.0";
    expect_silent(slot);
}

TEST(FineTools, SegmentsSmallerThanThoseOfTheBlank) {
    PressDeck press;
    press.tool_edge = 5;
    const Problem problem = the_warning(press);
    EXPECT_EQ(problem.field, "surf_IDm");
    EXPECT_SAYS(problem.value, "5 mm");
    EXPECT_SAYS(problem.rule, "10 mm");
    press.tool_edge = 10;
    expect_silent(press);
}

TEST(VoidBlanks, HaveNoGapWithIgap1And2) {
    PressDeck press;
    press.blank_material = "/MAT/VOID/1\nsheet\n             7.8e-09            210000.0                 0.3\n";
    press.gapmin = "0.0";
    press.igap = "2";
    const Problem problem = the_warning(press);
    EXPECT_EQ(problem.field, "Igap");
    EXPECT_SAYS(problem.value, "2, 9 nodes: 1, 2, 3");
    EXPECT_SAYS(problem.rule, "void");
    press.igap = "1";
    EXPECT_SAYS(the_warning(press).value, "1, 9 nodes");
    press.gapmin = "0.5";
    expect_silent(press);
}

TEST(FarCoordinates, WhereTheGapLosesDigits) {
    PressDeck press;
    press.origin = 1e7;
    const Problem problem = the_warning(press);
    EXPECT_SAYS(problem.value, "mm");
    EXPECT_SAYS(problem.rule, "0.5 mm keeps 8 of 16 digits");
    press.origin = 1e4;
    expect_silent(press);
}

TEST(SamePairs, AreNamedWithTheOtherInterface) {
    const std::string second = "/INTER/TYPE21/2\nagain\n         1         2\n\n\n\n\n\n\n\n\n\n\n         7\n";
    PressDeck press;
    press.cards = second;
    const Problem problem = the_warning(press);
    EXPECT_EQ(problem.card, "/INTER/TYPE21/2");
    EXPECT_SAYS(problem.value, "9 nodes, the first 1, and 9 segments");
    EXPECT_SAYS(problem.rule, "interface 1 too");
    // The second begins when the first has ended: Tstop of the one, Tstart of the other.
    press.fric = "0.0";
    press.times = fmt::format("{:>20}{:>20}", "0.0", "5e-4");
    press.cards = replaced(second, "2\n\n\n\n", "2\n\n\n" + fmt::format("{:>80}{:>20}\n", "5e-4", "0.0"));
    expect_silent(press);
}

TEST(SamePairs, ATriangleMayBeginWithAnyOfItsNodes) {
    PressDeck press;
    press.more_nodes =
        "       401               100.0                 0.0                 2.0\n"
        "       402               112.0                 0.0                 2.0\n"
        "       403               112.0                12.0                 2.0\n";
    press.more_shells = "       401       401       402       403       403\n";
    press.cards =
        "/SURF/SEG/3\nthe triangle\n         1       402       403       401       401\n"
        "/INTER/TYPE21/2\nagain\n         1         3\n\n\n\n\n\n\n\n\n\n\n         7\n";
    EXPECT_SAYS(the_warning(press).value, "9 nodes, the first 1, and 1 segment");
}

TEST(ImplausibleValues, DensityThicknessAndFriction) {
    PressDeck press;
    press.density = "7.8";
    Problem problem = the_warning(press);
    EXPECT_EQ(problem.card, "/MAT/VOID/2");
    EXPECT_SAYS(problem.value, "7.8 Mg/mm^3");
    press.density = "7.8e-06";  // a thousand times the mass is common practice
    expect_silent(press);
    press.density = "0.0";
    expect_silent(press);

    PressDeck thin;
    thin.thickness = "0.001";
    problem = the_warning(thin);
    EXPECT_EQ(problem.card, "/PROP/SHELL/1");
    EXPECT_SAYS(problem.value, "0.001 mm");

    PressDeck rough;
    rough.fric = "12.0";
    problem = the_warning(rough);
    EXPECT_EQ(problem.field, "Fric");
    EXPECT_EQ(problem.value, "12");
    rough.fric = "0.3";
    expect_silent(rough);
}

TEST(TwoDrives, OfOneFreedomAreNamedWithNodeAndBothCards) {
    PressDeck press;
    press.cards = "/IMPVEL/9\nagain\n         1         Z         0         0         3         0         0\n\n";
    Problem problem = the_warning(press);
    EXPECT_EQ(problem.card, "/IMPVEL/9");
    EXPECT_EQ(problem.value, "Z of node 201");
    EXPECT_SAYS(problem.rule, "/IMPVEL/1");

    press.cards = "/BCS/9\nheld\n   001 000         0         3\n";
    problem = the_warning(press);
    EXPECT_SAYS(problem.rule, "/BCS/9");
    EXPECT_EQ(problem.value, "Z of node 201");

    // Nine nodes of the blank are fixed and driven: one message with a count.
    press.cards = "/IMPDISP/9\nblank\n         1         X         0         0         1         0         0\n\n";
    EXPECT_EQ(the_warning(press).value, "X of node 1 and 8 more");
}

TEST(TwoDrives, OtherDirectionsAndTimesDoNotMeet) {
    PressDeck press;
    press.cards = "/BCS/9\nheld\n   110 000         0         3\n";  // twice the same: nothing is lost
    expect_silent(press);
    press.drive = "/IMPVEL/1\n";
    press.cards = "/IMPVEL/9\nlater\n         1         Z         0         0         3         0         0\n" +
                  fmt::format("{:>20}{:>20}{:>20}{:>20}\n", 1.0, 1.0, 2.0, 3.0);
    EXPECT_EQ(warnings_of(press).list().size(), 1U) << "the first has no end, so they meet";
}

TEST(TwoDrives, OfNodesThatFollowARigidBody) {
    PressDeck press;
    press.cards = "/IMPVEL/9\ntool\n         1         Z         0         0         2         0         0\n\n";
    const Problem problem = the_warning(press);
    EXPECT_EQ(problem.card, "/IMPVEL/9");
    EXPECT_SAYS(problem.value, "16 nodes, the first 101");
    EXPECT_SAYS(problem.remedy, "main node 201");
}

TEST(EndingFunctions, GoOnAlongTheirLastSlope) {
    PressDeck press;
    press.function = "                 0.0                 0.0\n               5e-04                 1.0\n";
    Problem problem = the_warning(press);
    EXPECT_EQ(problem.card, "/IMPVEL/1");
    EXPECT_SAYS(problem.value, "0.0005 s");
    EXPECT_SAYS(problem.rule, "from 1 to 2");
    // A velocity that stays at the last value moves the tool on.
    press.function += "               6e-04                 1.0\n";
    EXPECT_SAYS(the_warning(press).rule, "from 1 to 1");
}

TEST(EndingFunctions, AtRestOrConstantAreSilent) {
    PressDeck press;
    press.function = "                 0.0                 1.0\n               4e-04                 1.0\n";
    expect_silent(press);
    press.function += "               5e-04                 0.0\n               6e-04                 0.0\n";
    expect_silent(press);
    press.drive = "/IMPDISP/1\n";
    press.function =
        "                 0.0                 0.0\n               4e-04               0.001\n"
        "               5e-04               0.001\n";
    expect_silent(press);
}

TEST(LongSteps, FartherThanGapAndDepth) {
    PressDeck press;
    press.depth = "2.0";
    press.step = "1e-5";
    press.function = "                 0.0               300.0\n               1e-03               300.0\n";
    const Problem problem = the_warning(press);  // 300 000 mm/s for 1e-5 s
    EXPECT_EQ(problem.field, "DEPTH");
    EXPECT_SAYS(problem.rule, "3 mm in one step");
    EXPECT_SAYS(problem.rule, "gap + DEPTH = 2.5 mm");
    press.step = "1e-6";
    expect_silent(press);
}

}  // namespace
}  // namespace type21
