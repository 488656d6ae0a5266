#include <csignal>
#include <limits>
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "verification/results/paraview/base64.h"
#include "verification/results/paraview/contact_grid.h"
#include "verification/results/paraview/pvd_file.h"
#include "verification/results/paraview/vtu_file.h"
#include "verification/tests/results/record/record_scene.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;

/// No file may grow beyond `bytes` while this lives: a full disk for one test.
class FullDisk {
  public:
    explicit FullDisk(size_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        setrlimit(RLIMIT_FSIZE, &before_);
        std::signal(SIGXFSZ, handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

  private:
    void (*handler_)(int);
    rlimit before_{};
};

VtuGrid square() {
    VtuGrid grid;
    grid.time = 0.5;
    grid.points = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    grid.cells = {{0, 1, 2, 3}, {0, 1, 2, 2}};
    grid.point_arrays = {{"gap", "mm", 1, std::vector<double>{1, 2, 3, 4}}};
    return grid;
}

TEST(Base64, TheExamplesOfItsStandard) {
    const std::string text = "foobar";
    const std::vector<std::string> expected{"", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy"};
    for (size_t size = 0; size <= text.size(); ++size)
        EXPECT_EQ(base64(text.data(), size), expected[size]);
    const unsigned char high[] = {0xff, 0xfe, 0x80};
    EXPECT_EQ(base64(high, sizeof high), "//6A");
}

TEST(PvdFile, IsWholeAfterEachTime) {
    TempFolder folder;
    PvdFile list(folder / "a.pvd");
    const std::string empty = test::read_text(folder / "a.pvd");
    EXPECT_NE(empty.find("</VTKFile>"), std::string::npos);
    list.add(0.1, "a_0.vtu");
    list.add(0.25, "a_1.vtu");
    const std::string text = test::read_text(folder / "a.pvd");
    EXPECT_NE(text.find("<DataSet timestep=\"0.10000000000000001\" part=\"0\" file=\"a_0.vtu\""), std::string::npos);
    EXPECT_NE(text.find("<DataSet timestep=\"0.25\" part=\"0\" file=\"a_1.vtu\""), std::string::npos);
    EXPECT_TRUE(text.ends_with(empty.substr(empty.find("</Collection>")))) << text;
    EXPECT_EQ(text.find("</Collection>"), text.rfind("</Collection>"));
}

TEST(PvdFile, AFullDiskLeavesTheListAsItWas) {
    TempFolder folder;
    PvdFile list(folder / "a.pvd");
    list.add(0.1, "a_0.vtu");
    const std::string before = test::read_text(folder / "a.pvd");
    {
        const FullDisk full(before.size() + 10);
        EXPECT_THROW(list.add(0.2, "a_1.vtu"), std::runtime_error);
    }
    EXPECT_EQ(test::read_text(folder / "a.pvd"), before);
    list.add(0.2, "a_1.vtu");
    EXPECT_NE(test::read_text(folder / "a.pvd").find("a_1.vtu"), std::string::npos);
}

TEST(VtuFile, AFullDiskLeavesNothing) {
    TempFolder folder;
    write_vtu(folder / "a.vtu", square());
    const std::string before = test::read_text(folder / "a.vtu");
    EXPECT_NE(before.find("NumberOfPoints=\"4\" NumberOfCells=\"2\""), std::string::npos);
    {
        const FullDisk full(before.size() / 2);
        EXPECT_THROW(write_vtu(folder / "a.vtu", square()), std::runtime_error);
        EXPECT_THROW(write_vtu(folder / "b.vtu", square()), std::runtime_error);
    }
    EXPECT_EQ(test::read_text(folder / "a.vtu"), before);
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 1);
    EXPECT_THROW(write_vtu(folder / "none/a.vtu", square()), std::runtime_error);
}

/// One node of two in the secondary surface, on a tool of one triangle.
struct Touching : test::RecordScene {
    Touching() {
        model->nodes.id = {7, 9, 11, 13};
        model->surfaces.resize(2);
        model->surfaces[0].segments = {{{0, 1, 1, 1}, -1}};
        model->surfaces[1].segments = {{{1, 2, 3, 3}, -1}};
        Interface& interface = model->interfaces[0];
        interface.secondary_surface = 0;
        interface.main_surface = 1;
        interface.secondary.node = {0, 1};
        interface.secondary.area = {2, 0};
        interface.main_nodes = {1, 2, 3};
        cycle.position = {Vec3(0, 0, 1), Vec3(0, 0, 0), Vec3(4, 0, 0), Vec3(0, 3, 0)};
        NodeContact contact;
        contact.decision.kind = Kind::contact;
        contact.decision.segment = 0;
        contact.status = Status::slip;
        contact.gap = 0.5;
        contact.penetration = 0.125;
        contact.normal_force = 8;
        contact.normal = Vec3(0, 0, 1);
        contact.relative_velocity = Vec3(3, 4, 100);
        contact.friction = Vec3(1, 0, 0);
        contact.force = Vec3(-1, 0, 8);
        NodeContact open;
        open.gap = 0.25;
        cycle.contacts[0].nodes = {contact, open};
        interface.secondary.gap = {0.375, 0.625};
    }
    test::Cycle cycle;
};

template <class Number>
std::vector<Number> values(const std::vector<VtuArray>& arrays, const std::string& name) {
    for (const VtuArray& array : arrays)
        if (array.name == name) return std::get<std::vector<Number>>(array.values);
    throw std::runtime_error("no array " + name);
}

using Numbers = std::vector<double>;
using Whole = std::vector<std::int64_t>;

TEST(ContactGrid, TheBlankHasWhatTheContactSays) {
    Touching scene;
    ContactGrid grid(scene.scene, 0);
    const CycleRecord record = scene.cycle.record(1, 0.5, 0.25, 0.25, false);
    grid.add(record);
    grid.add(record);
    const VtuGrid blank = grid.blank(record);
    EXPECT_EQ(values<std::int64_t>(blank.point_arrays, "NODE_ID"), (Whole{7, 9}));
    EXPECT_EQ(values<std::int64_t>(blank.point_arrays, "SEGMENT_ID"), (Whole{1, 0}));
    EXPECT_EQ(values<std::int64_t>(blank.point_arrays, "status"), (Whole{2, 0}));
    EXPECT_EQ(values<double>(blank.point_arrays, "gap"), (Numbers{0.5, 0.25})) << "of the open node, too";
    EXPECT_EQ(values<double>(blank.point_arrays, "penetration"), (Numbers{0.125, 0}));
    EXPECT_EQ(values<double>(blank.point_arrays, "contact_pressure"), (Numbers{4, 0}));
    EXPECT_EQ(values<double>(blank.point_arrays, "contact_force"), (Numbers{-1, 0, 8, 0, 0, 0}));
    EXPECT_EQ(values<double>(blank.point_arrays, "tangential_force"), (Numbers{-1, 0, 0, 0, 0, 0}));
    // Two cycles of 0.25 at the speed 5 along the tool; what is across it does not count.
    EXPECT_EQ(values<double>(blank.point_arrays, "slip"), (Numbers{2.5, 0}));
}

TEST(ContactGrid, TheToolHasWhatItsNodesDoToIt) {
    Touching scene;
    std::vector<NodeContact>& nodes = scene.cycle.contacts[0].nodes;
    nodes[1] = nodes[0];
    nodes[1].status = Status::stick;
    nodes[1].penetration = 0.25;
    nodes[1].gap = 0.75;
    ContactGrid grid(scene.scene, 0);
    const CycleRecord record = scene.cycle.record(1, 0.5, 0.25, 0.25, false);
    grid.add(record);
    const VtuGrid tool = grid.tool(record);
    ASSERT_EQ(tool.cells.size(), 1U);
    EXPECT_EQ(tool.cells[0], (VtuCell{0, 1, 2, 2}));
    EXPECT_EQ(tool.points[1], Vec3(4, 0, 0));
    EXPECT_EQ(values<std::int64_t>(tool.cell_arrays, "nodes_in_contact"), Whole{2});
    EXPECT_EQ(values<std::int64_t>(tool.cell_arrays, "status"), Whole{2});
    EXPECT_EQ(values<double>(tool.cell_arrays, "penetration"), Numbers{0.25});
    EXPECT_EQ(values<double>(tool.cell_arrays, "gap"), Numbers{0.75});
    EXPECT_EQ(values<double>(tool.cell_arrays, "contact_force"), (Numbers{2, 0, -16}));
    EXPECT_EQ(values<double>(tool.cell_arrays, "tangential_force"), (Numbers{2, 0, 0}));
    EXPECT_EQ(values<double>(tool.cell_arrays, "contact_pressure"), Numbers{16.0 / 6.0});
    EXPECT_EQ(values<double>(tool.cell_arrays, "slip"), Numbers{1.25});
}

TEST(ContactGrid, ANodeThatIsOnlyNearIsOpen) {
    Touching scene;
    scene.cycle.contacts[0].nodes[0].decision.kind = Kind::proximity;
    ContactGrid grid(scene.scene, 0);
    const CycleRecord record = scene.cycle.record(1, 0.5, 0.25, 0.25, false);
    EXPECT_EQ(values<std::int64_t>(grid.blank(record).point_arrays, "SEGMENT_ID"), (Whole{0, 0}));
    EXPECT_EQ(values<double>(grid.blank(record).point_arrays, "contact_force"), (Numbers{0, 0, 0, 0, 0, 0}));
    scene.cycle.contacts[0].nodes.clear();  // an interface that does not act
    EXPECT_EQ(values<double>(grid.blank(record).point_arrays, "gap"), (Numbers{0.375, 0.625})) << "those of time 0";
    EXPECT_EQ(values<std::int64_t>(grid.tool(record).cell_arrays, "nodes_in_contact"), Whole{0});
}

}  // namespace
}  // namespace type21
