#include <algorithm>

#include <fmt/format.h>

#include "verification/report/criteria_report.h"
#include "verification/report/escaped_xml.h"

namespace type21 {
std::string criteria_junit(const std::vector<CriterionResult>& results) {
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const CriterionResult& result) { return !result.ok; });
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"type21 verify\" tests=\"{}\" "
        "failures=\"{}\">\n",
        results.size(), failed);
    for (const CriterionResult& result : results) {
        out += fmt::format("<testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3f}\"", escaped_xml(result.case_name),
                           escaped_xml(result.run), escaped_xml(result.id), result.seconds);
        if (result.skipped) {
            out += fmt::format("><skipped message=\"{}\"/></testcase>\n", escaped_xml(result.detail));
        } else if (result.ok) {
            out += "/>\n";
        } else {
            out += fmt::format(
                "><failure message=\"got {}, expected {}, difference {:.3e}, tolerance {:.3e}: {}\"/></testcase>\n",
                escaped_xml(result.got), escaped_xml(result.expected), result.difference, result.tolerance,
                escaped_xml(result.detail));
        }
    }
    return out + "</testsuite>\n</testsuites>\n";
}

}  // namespace type21
