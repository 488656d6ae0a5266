#include <algorithm>

#include <fmt/format.h>

#include "verification/report/criteria_report.h"

namespace type21 {
namespace {

/// Markup escaped; control characters, which XML forbids, become '?'.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
            case '&':
                out += "&amp;";
                break;
            case '<':
                out += "&lt;";
                break;
            case '>':
                out += "&gt;";
                break;
            case '"':
                out += "&quot;";
                break;
            default:
                out += static_cast<unsigned char>(c) < 0x20 ? '?' : c;
        }
    }
    return out;
}

}  // namespace

std::string criteria_junit(const std::vector<CriterionResult>& results) {
    const auto failed =
        std::count_if(results.begin(), results.end(), [](const CriterionResult& result) { return !result.ok; });
    std::string out = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites>\n<testsuite name=\"type21 verify\" tests=\"{}\" "
        "failures=\"{}\">\n",
        results.size(), failed);
    for (const CriterionResult& result : results) {
        out += fmt::format("<testcase classname=\"{}.{}\" name=\"{}\" time=\"{:.3f}\"", escaped(result.case_name),
                           escaped(result.run), escaped(result.id), result.seconds);
        if (result.skipped) {
            out += fmt::format("><skipped message=\"{}\"/></testcase>\n", escaped(result.detail));
        } else if (result.ok) {
            out += "/>\n";
        } else {
            out += fmt::format(
                "><failure message=\"got {}, expected {}, difference {:.3e}, tolerance {:.3e}: {}\"/></testcase>\n",
                escaped(result.got), escaped(result.expected), result.difference, result.tolerance,
                escaped(result.detail));
        }
    }
    return out + "</testsuite>\n</testsuites>\n";
}

}  // namespace type21
