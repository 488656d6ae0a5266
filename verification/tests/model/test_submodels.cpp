/// @file A deck with a submodel means the same as one that is written without.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "selecting.h"

namespace type21 {
namespace {

using namespace test;

using Ids = std::vector<Id>;

/// The tool of the driven scene as a submodel: its part, property, material, mesh and main node.
std::string in_submodel(const std::string& head, const std::string& cards) {
    return "//SUBMODEL/" + head + cards + "//ENDSUB\n";
}

std::string little_part(const std::string& node, const std::string& length) {
    return "/MAT/VOID/1\nm\n" + reals({"7.8e-09", "210000.0", "0.3"}) + "/PROP/VOID/1\np\n" + reals({length}) +
           "/PART/1\nlittle\n" + ints({"1", "1", "0"}) + "/NODE\n" + fmt::format("{:>10}", node) +
           reals({"0.0", "0.0", length}) + "         2" + reals({length, "0.0", length}) + "         3" +
           reals({"0.0", length, length}) + "/SH3N/1\n" + ints({"1", node, "2", "3"}) + "/GRNOD/NODE/1\nn\n" +
           ints({node, "3"}) + "/GRNOD/PART/2\nn\n" + ints({"1"}) + "/GRSH3N/SH3N/1\nn\n" + ints({"1"}) +
           "/SURF/GRSH3N/1\nn\n" + ints({"-1"}) + "/SURF/SEG/2\nn\n" + ints({"1", "3", "2", node}) +
           "/GRNOD/GENE/3\nn\n" + ints({"2", "3"}) + "/GRNOD/GRNOD/4\nn\n" + ints({"1", "3"});
}

TEST(Submodels, MoveTheIdsOfTheirCards) {
    Selecting s(with_cards(in_submodel("7\nsub\n" + ints({"500", "6000", "700", "80"}), little_part("1", "4.0"))));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
    EXPECT_EQ(s.nodes(501), (Ids{6001, 6003}));
    EXPECT_EQ(s.nodes(502), (Ids{6001, 6002, 6003}));
    EXPECT_EQ(s.nodes(503), (Ids{6002, 6003}));
    EXPECT_EQ(s.nodes(504), (Ids{6001, 6002, 6003}));
    EXPECT_EQ(s.sh3n(501), (Ids{701}));
    EXPECT_EQ(s.segments(501), "6002 6001 6003 6003");
    EXPECT_EQ(s.segments(502), "6003 6002 6001 6001");
    EXPECT_EQ(s.model.parts.back().id, 81);
    EXPECT_EQ(s.model.materials.back().id, 501) << "0 means Off_def";
    EXPECT_EQ(s.model.properties.back().id, 501);
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Submodels, HaveTheirOwnUnits) {
    const std::string metres = "/UNIT/5\nm\n" + reals({"kg", "m", "s"});
    for (const std::string& head :
         {metres + in_submodel("7/5\nsub\n" + ints({"500"}), little_part("1", "0.004")),
          in_submodel("7\nsub\n" + ints({"500"}), "/BEGIN\nsub\n" + ints({"2025", "0"}) + reals({"kg", "m", "s"}) +
                                                      reals({"kg", "m", "s"}) + little_part("1", "0.004"))}) {
        Selecting s(with_cards(head));
        EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
        EXPECT_DOUBLE_EQ(s.model.nodes.position.back().y(), 4);
        EXPECT_DOUBLE_EQ(s.model.properties.back().thickness, 4);
        EXPECT_DOUBLE_EQ(s.model.shells.back().thickness, 4);
        EXPECT_DOUBLE_EQ(s.model.units.length, 1e-3) << "the work units stay those of the main deck";
    }
}

TEST(Submodels, AreSelectedByTheirId) {
    const std::string cards = list_card("/GRNOD/SUBMODEL/31", {"7"}) + list_card("/GRSH3N/SUBMODEL/32", {"7"}) +
                              list_card("/GRPART/SUBMODEL/33", {"7"}) + list_card("/SURF/SUBMODEL/34", {"-7"}) +
                              list_card("/GRSHEL/SUBMODEL/35", {"7"});
    Selecting s(with_cards(in_submodel("7\nsub\n" + ints({"500"}), little_part("1", "4.0")) + cards));
    EXPECT_EQ(s.nodes(31), (Ids{501, 502, 503}));
    EXPECT_EQ(s.sh3n(32), (Ids{501}));
    EXPECT_EQ(s.parts(33), (Ids{501}));
    EXPECT_EQ(s.segments(34), "502 501 503 503");
    EXPECT_EQ(s.shells(35), (Ids{}));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
}

TEST(Submodels, AreMovedByATransform) {
    const std::string move = "/TRANSFORM/TRA/1\nup\n" + fmt::format("{:>10}", "") +
                             reals({"0", "0", "9"}).substr(0, 60) + ints({"", "", "7"});
    Selecting s(with_cards(in_submodel("7\nsub\n" + ints({"500"}), little_part("1", "4.0")) + move));
    EXPECT_TRUE(s.problems.list().empty()) << all_of(s.problems);
    EXPECT_EQ(s.model.nodes.position.back().z(), 13);
    EXPECT_EQ(s.model.nodes.position.front().z(), 0);
}

TEST(Submodels, AWholeSceneTwoWays) {
    // The driven scene with all but its interface, histories and titles moved by 300000.
    std::string text = driven_scene();
    const size_t begin = text.find("/MAT/ELAST/1");
    const size_t end = text.find("/INTER/TYPE21/1");
    text.insert(end, "//ENDSUB\n");
    text.insert(begin, "//SUBMODEL/1\nall\n" + ints({"300000"}));
    text = replaced(text, "/INTER/TYPE21/1\ncontact\n" + ints({"1", "2"}),
                    "/INTER/TYPE21/1\ncontact\n" + ints({"300001", "300002"}));
    text = replaced(text, std::string(10, '\n') + ints({"7"}), std::string(10, '\n') + ints({"300007"}));
    const Resolved moved = resolved(text);
    const Resolved plain = resolved(driven_scene());
    EXPECT_TRUE(moved.problems.list().empty()) << all_of(moved.problems);
    ASSERT_EQ(moved.model.nodes.size(), plain.model.nodes.size());
    for (size_t i = 0; i < plain.model.nodes.id.size(); ++i) {
        EXPECT_EQ(moved.model.nodes.id[i], plain.model.nodes.id[i] + 300000);
        EXPECT_EQ(moved.model.nodes.position[i], plain.model.nodes.position[i]);
    }
    EXPECT_EQ(moved.model.interfaces.at(0).secondary.node, plain.model.interfaces.at(0).secondary.node);
    EXPECT_EQ(moved.model.interfaces.at(0).main_nodes, plain.model.interfaces.at(0).main_nodes);
    EXPECT_EQ(moved.model.nodal_mass, plain.model.nodal_mass);
    EXPECT_EQ(moved.model.imposed_motions.at(0).group, plain.model.imposed_motions.at(0).group);
}

TEST(Submodels, MistakesAreNamed) {
    const auto problem = [](const std::string& cards) { return only(Selecting(with_cards(cards)).problems); };
    EXPECT_NE(problem("//SUBMODEL/1\nt\n" + ints({"0"})).rule.find("no //ENDSUB"), std::string::npos);
    EXPECT_NE(problem("//ENDSUB\n").rule.find("no //SUBMODEL"), std::string::npos);
    EXPECT_NE(problem("//SUBMODEL/1\nt\n//SUBMODEL/2\nt\n//ENDSUB\n").rule.find("within another"), std::string::npos);
    EXPECT_EQ(problem("//SUBMODEL/1\nt\n" + ints({"-5"}) + "//ENDSUB\n").value, "-5");
    EXPECT_NE(problem("//SUBMODEL/1\nt\n" + ints({"5"}) + "/FRICTION/1\nf\n" + ints({"0", "0"}) + "\n\n//ENDSUB\n")
                  .rule.find("would not be moved"),
              std::string::npos);
    Selecting unknown(with_cards(list_card("/GRNOD/SUBMODEL/31", {"7"}) + "//SUBMODEL/1\nt\n//ENDSUB\n"));
    EXPECT_TRUE(unknown.problems.list().empty()) << "nothing uses the group" << all_of(unknown.problems);
    unknown.nodes(31);
    EXPECT_EQ(only(unknown.problems).field, "submodel_ID");
    EXPECT_EQ(problem("//SUBMODEL/1\nt\n" + ints({"9999999999"}) + "/NODE\n" + ints({"5"}) + "//ENDSUB\n").field, "id");
}

}  // namespace
}  // namespace type21
