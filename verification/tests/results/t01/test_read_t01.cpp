#include <fmt/format.h>
#include <gtest/gtest.h>

#include "verification/results/compare/compare_tables.h"
#include "verification/results/t01/t01_file.h"
#include "verification/results/t01/t01_tables.h"
#include "verification/tests/results/t01/t01_writer.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;
namespace fs = std::filesystem;

fs::path source() {
    return TYPE21_SOURCE_DIR;
}

/// The message of a file that cannot be read; empty when it can.
std::string complaint(const fs::path& path) {
    try {
        read_t01(path);
    } catch (const T01Error& error) {
        return error.what();
    }
    return "";
}

const T01Table& table_of(const T01Tables& tables, const std::string& words) {
    for (const T01Table& table : tables.tables)
        if (table.name.find(words) != std::string::npos) return table;
    throw std::runtime_error("no table " + words);
}

TEST(ReadT01, TheFileOfDoublesIsItsTextToTheLastBit) {
    const fs::path folder = source() / "cases/flat_press";
    const T01File file = read_t01(folder / "flat_pressT01");
    EXPECT_EQ(file.code, 3040);
    EXPECT_EQ(file.title.substr(0, 17), "TYPE21 catalogue:");
    EXPECT_FALSE(file.storage.big_endian);
    EXPECT_EQ(file.storage.text_slot, 8);
    EXPECT_EQ(file.storage.real_bytes, 8);
    EXPECT_EQ(file.time.size(), 300U);
    const T01Tables tables = tables_of(file);
    ASSERT_EQ(tables.tables.size(), 3U);
    EXPECT_EQ(tables.notes.size(), 1U);  // the rigid body
    for (const auto& [name, csv] :
         {std::pair{"interface 1", "interface_1.csv"}, {"'blank'", "nodes.csv"}, {"'tool'", "tool.csv"}}) {
        const TableResult result =
            compare_tables(table_of(tables, name).table, read_csv(folder / csv), {.tolerance = 0});
        EXPECT_TRUE(result.ok()) << name;
        EXPECT_GE(result.columns.size(), 9U);
    }
}

TEST(ReadT01, TheFileOfFloatsIsItsText) {
    const fs::path folder = source() / "verification/tests/results/t01/data";
    const T01File file = read_t01(folder / "plateT01");
    EXPECT_TRUE(file.storage.big_endian);
    EXPECT_EQ(file.storage.text_slot, 4);
    EXPECT_EQ(file.storage.real_bytes, 4);
    const T01Tables tables = tables_of(file);
    for (const auto& [name, csv] : {std::pair{"interface 1", "interface_1.csv"}, {"'centre'", "nodes.csv"}}) {
        const CsvTable text = read_csv(folder / csv);
        const CsvTable& ours = table_of(tables, name).table;
        EXPECT_GT(ours.rounding, 0);
        EXPECT_TRUE(compare_tables(ours, text, {.tolerance = 0}).ok()) << name;
        // Codes 7 to 9 of a node are told apart by accelerations that differ.
        if (ours.has_object) {
            EXPECT_EQ(ours.columns, text.columns);
        }
    }
}

/// Two groups, one of a kind that is passed over.
T01File small_file(int code) {
    T01File file;
    file.code = code;
    file.title = "a small run";
    file.date = "today";
    file.time = {0, 0.25, 0.5};
    T01Group nodes{3, T01Group::node, "some nodes", {5, 9}, {1, 6, 622, 777}, {}};
    for (int i = 0; i < 24; ++i)
        nodes.values.push_back(i + 0.125);
    T01Group bodies{4, T01Group::rigid_body, "bodies", {1}, {1, 2}, std::vector<double>(6, 1.0)};
    file.groups = {bodies, nodes};
    return file;
}

TEST(ReadT01, EveryVersionInEveryStorage) {
    TempFolder folder;
    for (const int code : {3040, 3041, 3050, 4021}) {
        for (const T01Storage& storage : test::every_storage()) {
            const T01File written = small_file(code);
            test::write_text(folder / "smallT01", test::T01Writer(storage).bytes(written));
            const T01File file = read_t01(folder / "smallT01");
            EXPECT_EQ(file.code, code);
            EXPECT_EQ(file.title, "a small run");
            EXPECT_EQ(file.date, "today");
            EXPECT_EQ(file.time, written.time);
            ASSERT_EQ(file.groups.size(), 2U);
            EXPECT_EQ(file.groups[1].title, "some nodes");
            EXPECT_EQ(file.groups[1].objects, (std::vector<Id>{5, 9}));
            EXPECT_EQ(file.groups[1].values, written.groups[1].values);
            EXPECT_TRUE(file.groups[0].values.empty());
        }
    }
}

TEST(ReadT01, UnknownVariablesAreLeftOutAndSaidSo) {
    T01File file = small_file(3040);
    file.storage.real_bytes = 8;
    const T01Tables tables = tables_of(file);
    ASSERT_EQ(tables.tables.size(), 1U);
    EXPECT_EQ(tables.tables[0].table.columns, (std::vector<std::string>{"DX", "VZ", "REACZ"}));
    EXPECT_EQ(tables.tables[0].table.values[1], (std::vector<double>{1.125, 5.125, 9.125, 13.125, 17.125, 21.125}));
    EXPECT_EQ(tables.tables[0].table.object, (std::vector<Id>{5, 9, 5, 9, 5, 9}));
    ASSERT_EQ(tables.notes.size(), 2U);
    EXPECT_NE(tables.notes[1].find("777"), std::string::npos);
}

TEST(ReadT01, AnInterfaceOfTwoGroupsIsOneTable) {
    T01File file;
    file.file = "xT01";
    file.time = {0, 1};
    file.groups = {{1, T01Group::interface, "a", {7, 8}, {1, 7}, {1, 0, 2, 0, 3, 0, 4, 0}},
                   {2, T01Group::interface, "b", {8}, {26, 1}, {5, 2, 6, 4}}};
    const T01Tables tables = tables_of(file);
    ASSERT_EQ(tables.tables.size(), 2U);
    EXPECT_EQ(tables.tables[1].ours, "interface_8.csv");
    EXPECT_EQ(tables.tables[1].table.columns, (std::vector<std::string>{"FNX", "CE_ELAST"}));
    EXPECT_EQ(tables.tables[1].table.values[0], (std::vector<double>{2, 4}));
    EXPECT_EQ(tables.tables[1].table.values[1], (std::vector<double>{5, 6}));
}

TEST(ReadT01, ADamagedFileIsNamedWithTheByte) {
    TempFolder folder;
    const fs::path path = folder / "xT01";
    const std::string good = test::T01Writer({}).bytes(small_file(3040));
    const auto with = [&](size_t at, const std::string& bytes) {
        std::string text = good;
        text.replace(at, bytes.size(), bytes);
        test::write_text(path, text);
        return complaint(path);
    };
    EXPECT_NE(complaint(folder / "none").find("cannot be read"), std::string::npos);
    test::write_text(path, "");
    EXPECT_NE(complaint(path).find("byte 0: 0 bytes"), std::string::npos);
    test::write_text(path, "time,FNX\n0,0\n");
    EXPECT_NE(complaint(path).find("byte 0: the file begins with the bytes 74 69 6d 65"), std::string::npos);
    EXPECT_NE(with(4, std::string("\0\0\0\1", 4)).find("byte 0: the format version 1 is not known"), std::string::npos);
    // The length behind the first record: 4 + 84 bytes on.
    EXPECT_NE(with(88, std::string("\0\0\0\1", 4)).find("byte 88: the length behind"), std::string::npos);
    EXPECT_NE(with(92, std::string("\x7f\xff\xff\xff", 4)).find("byte 92: a record of 2147483647 bytes"),
              std::string::npos);
    // A count of parts that cannot be, and one that the file does not hold: nothing is set aside for it.
    EXPECT_NE(with(184, std::string("\xff\xff\xff\xff", 4)).find("byte 180: -1 parts"), std::string::npos);
    EXPECT_NE(with(188, std::string("\x7f\xff\xff\xff", 4)).find("where a material or property should be"),
              std::string::npos);
    test::write_text(path, good.substr(0, good.size() - 1));
    EXPECT_NE(complaint(path).find("the file ends inside the values of /TH group 3 at t = 0.5"), std::string::npos);
    test::write_text(path, good + "x");
    EXPECT_NE(complaint(path).find(fmt::format("byte {}: the file ends where an output time", good.size())),
              std::string::npos);
    test::write_text(path, good);
    EXPECT_EQ(complaint(path), "");
}

}  // namespace
}  // namespace type21
