/// @file `type21 compare RUN NAMET01` and `type21 compare RUN FILE.csv`.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "verification/results/t01/t01_file.h"
#include "verification/results/tables/csv_table.h"
#include "verification/tests/cli/program.h"
#include "verification/tests/results/t01/t01_writer.h"

namespace type21 {
namespace {

using test::DeckCopy;
using test::in_quotes;
using test::Outcome;
using test::TempFolder;

std::filesystem::path measured() {
    return test::cases() / "flat_press/flat_pressT01";
}

/// A result of flat_press, run once for all tests of this file.
std::string run_folder() {
    static const DeckCopy deck("flat_press");
    static const Outcome outcome =
        test::type21("run " + in_quotes(deck.starter) + " --quiet --as-built all --out " + in_quotes(deck.out()));
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return in_quotes(deck.out());
}

Outcome compare(const std::filesystem::path& reference, const std::string& options = "") {
    return test::type21("compare " + run_folder() + " " + in_quotes(reference) + " " + options);
}

TEST(CompareT01, TheMeasuredFileOfDoublesAgreesAtTheToleranceOfDoubles) {
    const Outcome outcome = compare(measured());
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("300 rows compared"), std::string::npos);
    EXPECT_NE(outcome.out.find("3600 rows compared"), std::string::npos);
    EXPECT_EQ(outcome.out.find("interpolated"), std::string::npos);
}

/// The same numbers as /TFILE/4 would have stored them. A float is off by half a unit in the last place of 24 bits,
/// 6e-8 of the value; the default tolerance is twice that. Its times are floats too and still find their partners.
TEST(CompareT01, EveryStorageAgreesAtTheToleranceOfItsReals) {
    TempFolder folder;
    T01File file = read_t01(measured());
    std::erase_if(file.groups, [](const T01Group& group) { return !group.kept(); });
    for (const T01Storage& storage : test::every_storage()) {
        test::write_text(folder / "xT01", test::T01Writer(storage).bytes(file));
        const Outcome outcome = compare(folder / "xT01");
        EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
        EXPECT_EQ(outcome.out.find("interpolated"), std::string::npos) << outcome.out;
        EXPECT_EQ(outcome.out.find("single precision") != std::string::npos, storage.real_bytes == 4);
        EXPECT_EQ(compare(folder / "xT01", "--tolerance 1e-9").code, storage.real_bytes == 4 ? 3 : 0);
    }
}

TEST(CompareT01, AChangeIsFoundWhereItBegins) {
    TempFolder folder;
    T01File file = read_t01(measured());
    std::erase_if(file.groups, [](const T01Group& group) { return !group.kept(); });
    ASSERT_EQ(file.groups[0].variables[2], 3);  // FNZ
    for (size_t t = 200; t < 300; ++t)
        file.groups[0].values[t * file.groups[0].variables.size() + 2] *= 1 + 1e-8;
    test::write_text(folder / "xT01", test::T01Writer({true, 4, 8}).bytes(file));
    const Outcome outcome = compare(folder / "xT01", "--json " + in_quotes(folder / "c.json"));
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("first difference above its tolerance at t = 0.0002: FNZ"), std::string::npos)
        << outcome.out;
    const auto json = nlohmann::json::parse(test::read_text(folder / "c.json"));
    EXPECT_EQ(json["first_difference"]["column"], "FNZ");
    EXPECT_NEAR(json["first_difference"]["time"].get<double>(), 2e-4, 1e-12);
}

TEST(CompareT01, OtherTimesAreInterpolated) {
    TempFolder folder;
    T01File file = read_t01(measured());
    std::erase_if(file.groups, [](const T01Group& group) { return group.type != T01Group::node; });
    file.groups.resize(1);
    file.groups[0].values.resize(100 * file.groups[0].objects.size() * file.groups[0].variables.size());
    for (double& value : file.groups[0].values)
        value = 0;  // the blank is fixed: DX .. VZ stay 0 between the times too
    file.time.resize(100);
    for (size_t t = 0; t < 100; ++t)
        file.time[t] = 3.0125e-6 * static_cast<double>(t);
    test::write_text(folder / "xT01", test::T01Writer({true, 4, 8}).bytes(file));
    const Outcome outcome = compare(folder / "xT01", "--columns DX,DY,DZ,VX,VY,VZ");
    EXPECT_EQ(outcome.code, 0) << outcome.out;
    EXPECT_NE(outcome.out.find("interpolated linearly"), std::string::npos);
}

TEST(CompareT01, ADamagedFileIsExitTwoWithTheByte) {
    TempFolder folder;
    test::write_text(folder / "xT01", test::read_text(measured()).substr(0, 5000));
    const Outcome outcome = compare(folder / "xT01");
    EXPECT_EQ(outcome.code, 2);
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err.find("xT01: byte 4736: the file ends inside"), std::string::npos) << outcome.err;
    EXPECT_EQ(compare(test::cases() / "flat_press/README.md").code, 2);
}

TEST(CompareCsv, AnyFileWithOurColumns) {
    TempFolder folder;
    std::filesystem::copy_file(test::cases() / "flat_press/interface_1.csv", folder / "of_a_colleague.csv");
    EXPECT_EQ(compare(folder / "of_a_colleague.csv").code, 0);  // the run has one interface
    EXPECT_EQ(compare(test::cases() / "flat_press/tool.csv").code, 0);
    std::string text = test::read_text(test::cases() / "flat_press/nodes.csv");
    test::write_text(folder / "n.csv", text.replace(text.rfind(',') + 1, std::string::npos, "1.5\n"));
    const Outcome outcome = compare(folder / "n.csv");
    EXPECT_EQ(outcome.code, 3);
    EXPECT_NE(outcome.out.find("first difference above its tolerance"), std::string::npos);
    EXPECT_NE(outcome.out.find("REACZ of node 1012"), std::string::npos) << outcome.out;
    test::write_text(folder / "bad.csv", "time,FNX\n0,zero\n");
    EXPECT_EQ(compare(folder / "bad.csv").code, 2);
}

TEST(CompareCsv, AnInterfaceThatCannotBeToldIsAWrongCommand) {
    TempFolder folder;
    for (const char* name : {"interface_1.csv", "interface_2.csv"})
        test::write_text(folder / ("run/" + std::string(name)), "time,FNX\n0,0\n1,1\n");
    test::write_text(folder / "x.csv", "time,FNX\n0,0\n1,1\n");
    const Outcome outcome = test::type21("compare " + in_quotes(folder / "run") + " " + in_quotes(folder / "x.csv"));
    EXPECT_EQ(outcome.code, 1);
    EXPECT_NE(outcome.err.find("Name it interface_<id>.csv"), std::string::npos);
    std::filesystem::rename(folder / "x.csv", folder / "interface_2.csv");
    EXPECT_EQ(test::type21("compare " + in_quotes(folder / "run") + " " + in_quotes(folder / "interface_2.csv")).code,
              0);
}

/// The interface of the run as another program might hand it over.
std::string as_written(const std::string& header, const std::string& separator, double time_factor, double factor) {
    const CsvTable ours = read_csv(test::cases() / "flat_press/interface_1.csv");
    std::string text = header + "\n";
    for (size_t row = 0; row < ours.rows(); ++row)
        text += fmt::format("{}{}{}\n", ours.time[row] * time_factor, separator,
                            ours.values[*ours.column("FNZ")][row] * factor);
    return text;
}

TEST(CompareCsv, TheFormsOfOtherProgramsAreRead) {
    TempFolder folder;
    for (const char* header : {"\"time\",\"FNZ\"", "Time,FNZ", "\xEF\xBB\xBFtime [s],FNZ [N s]",
                               "# a solver\ntime (s),fnz", "\"time\",\"INTER 1 contact FNZ\""}) {
        const Outcome outcome = compare(folder.write("x.csv", as_written(header, ",", 1, 1)));
        EXPECT_EQ(outcome.code, 0) << header << outcome.out << outcome.err;
    }
    std::string semicolons = as_written("time [ms];FNZ [kN s]", ";", 1e3, 1e-3);
    std::replace(semicolons.begin(), semicolons.end(), '.', ',');
    const Outcome outcome = compare(folder.write("x.txt", semicolons), "--tolerance 1e-12");
    EXPECT_EQ(outcome.code, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("FNZ: the reference is in kN s, ours in N s: multiplied by 1000"), std::string::npos);
}

TEST(CompareCsv, OptionsAndTheirMistakes) {
    TempFolder folder;
    const std::string file = folder.write("x.csv", as_written("Zeit,Kraft Z", ",", 1e3, -1e-3));
    const std::string map = "--map time=Zeit --map FNZ='Kraft Z' ";
    const Outcome wrong = compare(file, map + "--time-scale 0.001");
    EXPECT_EQ(wrong.code, 3);
    EXPECT_NE(wrong.out.find("--scale COLUMN=-1000"), std::string::npos) << wrong.out;
    const Outcome right = compare(
        file, map + "--time-scale 0.001 --scale FNZ=-1000 --tolerance 1e-12 --junit " + in_quotes(folder / "j.xml"));
    EXPECT_EQ(right.code, 0) << right.out << right.err;
    EXPECT_NE(test::read_text(folder / "j.xml").find("tests=\"1\" failures=\"0\""), std::string::npos);
    for (const auto& [options, part] : std::vector<std::pair<std::string, std::string>>{
             {"--map time=Zeit --map FNZ=Kraft", "the reference has no column 'Kraft'; it has Kraft Z"},
             {"--map time=Zeit --map FZZ='Kraft Z'", "has no column 'FZZ'; it has FNX, FNY, FNZ"},
             {"--map FNZ", "write OURS=THEIRS"},
             {map + "--scale FNX=10", "there is no column 'FNX'; there are FNZ, Kraft Z"},
             {map + "--scale FNZ=much", "'much' is not a finite number other than 0"},
             {map + "--scale FNZ=0", "other than 0"},
             {map + "--time-scale -1", "larger than 0"},
             {map + "--columns FNX", "the reference has no column 'FNX'; it has FNZ"}}) {
        const Outcome outcome = compare(file, options);
        EXPECT_EQ(outcome.code, 1) << options << outcome.out;
        EXPECT_NE(outcome.err.find(part), std::string::npos) << options << ": " << outcome.err;
    }
}

}  // namespace
}  // namespace type21
