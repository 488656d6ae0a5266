/// @file A measured scene whose surfaces and groups are given in other ways gives the same bits.
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "reference/cycle/contact.h"
#include "reference/host/march.h"
#include "reference/host/prepare_deck.h"
#include "verification/tests/deck/problem_search.h"

namespace type21 {
namespace {

using namespace test;

std::string text_of(const std::string& file) {
    std::ifstream stream(std::string(TYPE21_SOURCE_DIR) + "/cases/flat_press/" + file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

std::string fields(const std::vector<std::string>& ids) {
    std::string line;
    for (const std::string& id : ids)
        line += fmt::format("{:>10}", id);
    return line + "\n";
}

/// Every impulse, energy and reaction of every cycle.
std::vector<double> run(const std::string& starter) {
    const TempFolder folder;
    const std::string path = folder.write("press_0000.rad", starter);
    folder.write("press_0001.rad", text_of("flat_press_0001.rad"));
    const PreparedDeck deck = prepare_deck(path, "", true);
    EXPECT_TRUE(deck.scene.has_value()) << all_of(deck.problems);
    std::vector<double> numbers;
    if (!deck.scene) return numbers;
    const auto keep = [&](const Vec3& v) { numbers.insert(numbers.end(), v.begin(), v.end()); };
    march(
        *deck.scene,
        [](const Scene& scene, int interface) { return std::make_unique<reference::Contact>(scene, interface); },
        [&](const CycleRecord& record) {
            const InterfaceTotals& totals = record.totals->at(0);
            keep(totals.normal);
            keep(totals.tangential);
            numbers.push_back(totals.elastic_energy);
            numbers.push_back(totals.damping_energy);
            for (const Vec3& reaction : *record.reaction)
                keep(reaction);
        },
        deck.options());
    return numbers;
}

TEST(WaysToSelect, TheSurfacesOfAMeasuredScene) {
    const std::string base = text_of("flat_press_0000.rad");
    const std::vector<double> wanted = run(base);
    ASSERT_GT(wanted.size(), 1000U);
    const std::string blank = "/SURF/PART/1\nblank surface\n" + fields({"1"});
    const std::string tool = "/SURF/PART/2\ntool surface\n" + fields({"101"});
    const std::string nodes = "/GRNOD/PART/101\ntool nodes\n" + fields({"101"});
    const auto card = [](const std::string& keyword, const std::vector<std::string>& ids) {
        return keyword + "\nother way\n" + fields(ids);
    };
    const std::string set = "/SET/GENERAL/9\nother way\nPART      " + fields({"1"});
    struct Way {
        std::string from, to;
    };
    for (const Way& way :
         {Way{blank, card("/SURF/GRSHEL/1", {"7"}) + card("/GRSHEL/PART/7", {"1"})},
          Way{blank, card("/SURF/MAT/1", {"1"})}, Way{blank, card("/SURF/PROP/EXT/1", {"1"})},
          Way{blank, card("/SURF/GRPART/1", {"7"}) + card("/GRPART/GENE/7", {"1", "100"})},
          Way{blank, card("/SURF/SURF/1", {"9"}) + set},
          Way{blank, card("/SURF/SURF/1", {"-8"}) + card("/SURF/PART/8", {"-1"})},
          Way{tool, card("/SURF/GRSHEL/2", {"7"}) + card("/GRSHEL/GRSHEL/7", {"8", "-9"}) +
                        card("/GRSHEL/GENE/8", {"1", "99999999"}) + card("/GRSHEL/PART/9", {"1"})},
          Way{nodes, card("/GRNOD/SURF/101", {"2"})}, Way{nodes, card("/GRNOD/MAT/101", {"2"})},
          Way{nodes, card("/GRNOD/GRSHEL/101", {"7"}) + card("/GRSHEL/PROP/7", {"101"})},
          Way{nodes, card("/GRNOD/GRNOD/101", {"57", "-1", "-201"}) + card("/GRNOD/BOX/57", {"7"}) +
                         "/BOX/SPHER/7\neverything\n" + fmt::format("{:>10}{:>20}\n\n", "", "1000.0")}}) {
        EXPECT_EQ(run(replaced(base, way.from, way.to)), wanted) << way.to;
    }
}

}  // namespace
}  // namespace type21
