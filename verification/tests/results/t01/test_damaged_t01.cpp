/// @file Damaged files: each ends in a T01Error or in a file as large as its bytes, never in anything else.
#include <random>
#include <sys/resource.h>

#include <gtest/gtest.h>

#include "verification/results/t01/t01_tables.h"
#include "verification/tests/temp_folder.h"

namespace type21 {
namespace {

using test::TempFolder;

class Damage {
  public:
    std::string of(std::string bytes) {
        const int times = between(1, 4);
        for (int i = 0; i < times; ++i)
            spoil(bytes);
        return bytes;
    }

  private:
    int between(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
    size_t place(const std::string& bytes) {
        // Mostly the head, where lengths and counts are.
        const size_t reach = between(0, 3) == 0 ? bytes.size() : std::min<size_t>(bytes.size(), 1600);
        return reach == 0 ? 0 : static_cast<size_t>(between(0, static_cast<int>(reach) - 1));
    }
    void spoil(std::string& bytes) {
        const size_t at = place(bytes);
        if (bytes.size() < 8) return;
        switch (between(0, 5)) {
            case 0:
                bytes[at] = static_cast<char>(between(0, 255));
                return;
            case 1:
                bytes.resize(at);
                return;
            case 2:
                bytes.erase(at, static_cast<size_t>(between(1, 8)));
                return;
            case 3:
                bytes.insert(at, static_cast<size_t>(between(1, 8)), static_cast<char>(between(0, 255)));
                return;
            case 4:  // a whole number, large or negative
                bytes.replace(at / 4 * 4, 4, between(0, 1) == 0 ? "\x7f\xff\xff\xff" : "\xff\xff\xff\xff");
                return;
            default:
                bytes.replace(at / 4 * 4, 4, std::string(4, '\0'));
        }
    }
    std::mt19937 random_{20211};
};

TEST(DamagedT01, NeverMoreThanAnError) {
    TempFolder folder;
    const std::filesystem::path root = TYPE21_SOURCE_DIR;
    // The head and a few whole output times: many small files rather than a few large ones.
    const std::vector<std::pair<std::filesystem::path, size_t>> files{
        {root / "cases/flat_press/flat_pressT01", 3512 + 5 * 1648},
        {root / "verification/tests/results/t01/data/plateT01", 1308 + 39 * 268}};
    Damage damage;
    size_t refused = 0, read = 0;
    rusage before{};
    getrusage(RUSAGE_SELF, &before);
    for (const auto& [file, bytes_kept] : files) {
        const std::string good = test::read_text(file).substr(0, bytes_kept);
        test::write_text(folder / "xT01", good);
        ASSERT_GE(read_t01(folder / "xT01").time.size(), 5U);
        for (int i = 0; i < 400; ++i) {
            const std::string bytes = damage.of(good);
            test::write_text(folder / "xT01", bytes);
            try {
                const T01File spoiled = read_t01(folder / "xT01");
                for (const T01Group& group : spoiled.groups)
                    EXPECT_LE(group.values.size() * 4, bytes.size());
                tables_of(spoiled);
                ++read;
            } catch (const T01Error& error) {
                EXPECT_NE(std::string(error.what()).find("xT01: byte "), std::string::npos) << error.what();
                ++refused;
            }
        }
    }
    rusage after{};
    getrusage(RUSAGE_SELF, &after);
    EXPECT_GT(refused, 500U);
    EXPECT_GT(read, 20U);
    // The size of the largest working set, in KiB: no count in a damaged file makes the reader set memory aside.
    EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 512 * 1024);
}

}  // namespace
}  // namespace type21
