#include "verification/report/comparison_junit.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "verification/report/escaped_xml.h"

namespace type21 {
namespace {

class JunitCases {
  public:
    /// @param failure  empty for a test that passed
    void add(const std::string& file, const std::string& name, const std::string& failure, const std::string& more) {
        ++tests_;
        cases_ += fmt::format("<testcase classname=\"{}\" name=\"{}\"", escaped_xml(file), escaped_xml(name));
        if (failure.empty()) {
            cases_ += "/>\n";
            return;
        }
        ++failures_;
        cases_ +=
            fmt::format("><failure message=\"{}\">{}</failure></testcase>\n", escaped_xml(failure), escaped_xml(more));
    }
    std::string xml() const {
        return fmt::format(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"type21 compare\" tests=\"{}\" "
            "failures=\"{}\">\n{}</testsuite>\n</testsuites>\n",
            tests_, failures_, cases_);
    }

  private:
    std::string cases_;
    int tests_ = 0, failures_ = 0;
};

std::string failure_of(const ColumnResult& column) {
    if (column.ok) return "";
    const std::string object = column.object ? fmt::format(" of node {}", *column.object) : "";
    return fmt::format(
        "difference {:.3e} at t = {:.6g}{}: ours {:.9g}, reference {:.9g}; scaled {:.3e}, tolerance {:.1e}",
        column.difference, column.time, object, column.ours, column.reference, column.scaled, column.tolerance);
}

}  // namespace

std::string comparison_junit(const FolderComparison& comparison) {
    JunitCases cases;
    for (const FileComparison& file : comparison.files) {
        const std::string hints = fmt::format("{}", fmt::join(file.table.hints, "; "));
        for (const ColumnResult& column : file.table.columns)
            cases.add(file.name, column.column, failure_of(column), hints);
        for (const std::string& mismatch : file.table.mismatches)
            cases.add(file.name, "rows and columns", mismatch, hints);
    }
    for (const std::string& mismatch : comparison.mismatches)
        cases.add("folder", "files", mismatch, fmt::format("{}", fmt::join(comparison.hints, "; ")));
    if (comparison.nothing_in_common) cases.add("folder", "files", "there is no history that could be compared", "");
    return cases.xml();
}

}  // namespace type21
