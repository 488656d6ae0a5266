#include <limits>

#include <gtest/gtest.h>

#include "verification/results/record/recorder.h"
#include "verification/results/record/run_id.h"
#include "verification/results/tables/csv_table.h"
#include "verification/tests/results/record/record_scene.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::Cycle;
using test::read_text;
using test::RecordScene;
using test::TempFolder;
using Kind = HistoryRequest::Kind;

const char* const all_columns =
    "time,FNX,FNY,FNZ,FTX,FTY,FTZ,|FNX|,|FNY|,|FNZ|,||FN||,|FX|,|FY|,|FZ|,||F||,QFRIC,CE_ELAST,CE_FRIC,CE_DAMP";

std::string first_line(const std::filesystem::path& path) {
    const std::string text = read_text(path);
    return text.substr(0, text.find('\n'));
}

TEST(Recorder, AnInterfaceThatNoRequestNamesHasEveryColumn) {
    RecordScene small;
    small.request(Kind::interface, {"FNZ", "CE_DAMP", "FNX"}, {1});
    TempFolder folder;
    const Recorder recorder(small.scene, folder.path());
    EXPECT_EQ(first_line(folder / "interface_10.csv"), all_columns);
    // The subset keeps the order of the columns, not that of the request.
    EXPECT_EQ(first_line(folder / "interface_11.csv"), "time,FNX,FNZ,CE_DAMP");
}

TEST(Recorder, EveryColumnHoldsItsOwnQuantity) {
    RecordScene small;
    TempFolder folder;
    Cycle cycle;
    InterfaceTotals& t = cycle.totals[0];
    t.normal = Vec3(1, 2, 3);
    t.tangential = Vec3(4, 5, 6);
    t.abs_normal = Vec3(7, 8, 9);
    t.signed_normal = 10;
    t.abs_total = Vec3(11, 12, 13);
    t.norm_total = 14;
    t.friction_heat = 15;
    t.elastic_energy = 16;
    t.friction_energy = 17;
    t.damping_energy = 18;
    Recorder recorder(small.scene, folder.path());
    recorder.observe(cycle.record(0, 0.25, 0, 1, true));
    recorder.flush();
    const CsvTable table = read_csv(folder / "interface_10.csv");
    ASSERT_EQ(table.rows(), 1U);
    EXPECT_EQ(table.time[0], 0.25);
    for (size_t c = 0; c < table.columns.size(); ++c)
        EXPECT_EQ(table.values[c][0], static_cast<double>(c + 1)) << table.columns[c];
}

TEST(Recorder, NodesHoldTheUnionOfTheRequestsOncePerTime) {
    RecordScene small;
    small.request(Kind::node, {"DX", "REACXX"}, {0, 1});
    small.request(Kind::node, {"VRZ", "Z", "AX", "DX", "REACY"}, {1});
    TempFolder folder;
    Cycle cycle;
    Recorder recorder(small.scene, folder.path());
    recorder.observe(cycle.record(0, 0, 0, 1, false));
    recorder.flush();
    EXPECT_EQ(read_text(folder / "nodes.csv"),
              "time,node,DX,AX,VRZ,REACY,REACXX,Z\n"
              "0,7,0.5,1,0,-2,7,3\n"
              "0,9,0,2,0.29999999999999999,-5,10,6.5\n");
}

TEST(Recorder, WritesNoNodesThatNobodyAsksFor) {
    RecordScene small;
    TempFolder folder;
    const Recorder recorder(small.scene, folder.path());
    EXPECT_FALSE(std::filesystem::exists(folder / "nodes.csv"));
}

TEST(Recorder, TheToolGetsImpulsesOfAllCyclesAndInterfaces) {
    RecordScene small;
    small.model->engine.history_interval = 2;  // cycle 1 is summed, not written
    TempFolder folder;
    Cycle cycle;
    cycle.contacts[0].tool.force = Vec3(1, 0, 0);
    cycle.contacts[1].tool.force = Vec3(0, 2, 0);
    cycle.contacts[1].tool.moment = Vec3(0, 0, 4);
    Recorder recorder(small.scene, folder.path());
    recorder.observe(cycle.record(0, 0, 0, 1, false));
    recorder.observe(cycle.record(1, 1, 1, 1, false));
    recorder.observe(cycle.record(2, 2, 1, 1, true));
    recorder.flush();
    const CsvTable table = read_csv(folder / "rbody.csv");
    ASSERT_EQ(table.rows(), 2U);
    EXPECT_EQ(table.object[0], 3);
    // w = (0 + 1)/2, then 1, then 1.
    EXPECT_EQ(table.values[*table.column("FX")], (std::vector<double>{0.5, 2.5}));
    EXPECT_EQ(table.values[*table.column("FY")], (std::vector<double>{1, 5}));
    EXPECT_EQ(table.values[*table.column("MZ")], (std::vector<double>{2, 10}));
    EXPECT_EQ(table.values[*table.column("Z")][0], 6.5);
    EXPECT_EQ(table.values[*table.column("DZ")][0], 0.5);
    EXPECT_EQ(table.values[*table.column("VY")][0], 50);
    EXPECT_EQ(table.values[*table.column("VRX")][0], 0.1);
}

TEST(Recorder, PutsOnDiskWhatItIsToldToAndMarksItAtTheEnd) {
    RecordScene small;
    TempFolder folder;
    Cycle cycle;
    Recorder recorder(small.scene, folder.path());
    for (int n = 0; n < 3; ++n)
        recorder.observe(cycle.record(n, n, 1, 1, false));
    recorder.flush();
    EXPECT_EQ(read_csv(folder / "interface_10.csv").rows(), 3U);
    EXPECT_EQ(run_id_in(folder / "interface_10.csv"), "");
    recorder.close("of-this-run");
    EXPECT_EQ(read_csv(folder / "interface_10.csv").rows(), 3U);
    for (const char* name : {"interface_10.csv", "interface_11.csv", "rbody.csv"})
        EXPECT_EQ(run_id_in(folder / name), "of-this-run") << name;
}

TEST(Recorder, ANumberThatIsNotFiniteIsNeverWritten) {
    RecordScene small;
    TempFolder folder;
    Cycle cycle;
    Recorder recorder(small.scene, folder.path());
    cycle.totals[1].norm_total = std::numeric_limits<double>::infinity();
    try {
        recorder.observe(cycle.record(0, 0.25, 0, 1, false));
        FAIL() << "no exception";
    } catch (const std::logic_error& error) {
        const std::string text = error.what();
        for (const char* part : {"interface_11.csv", "||F||", "inf", "0.25"})
            EXPECT_NE(text.find(part), std::string::npos) << text;
    }
}

TEST(Digits17, GiveBackTheSameDouble) {
    for (const double value : {0.1, 1.0 / 3.0, 1e-300, -0.0, 1.7976931348623157e308, 299.0, 2.9900000000000075e-4})
        EXPECT_EQ(std::stod(digits17(value)), value) << digits17(value);
    EXPECT_EQ(digits17(0.1), "0.10000000000000001");
    EXPECT_EQ(digits17(-3000.0), "-3000");
    EXPECT_EQ(digits17(1e-6), "9.9999999999999995e-07");
}

}  // namespace
}  // namespace type21
