#include <cmath>

#include "verification/report/criteria_report.h"
#include "verification/support/build_info.h"

namespace type21 {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) {
    if (std::isnan(value)) return "nan";
    if (std::isinf(value)) return "inf";
    return value;
}

/// The number where there is one, else its text.
Json number_or_text(const std::optional<double>& value, const std::string& text) {
    if (value) return *value;
    return text;
}

}  // namespace

Json criteria_json(const std::vector<CriterionResult>& results) {
    const BuildInfo& build = build_info();
    Json out = Json::array();
    for (const CriterionResult& result : results) {
        Json record = {{"id", result.id},
                       {"case", result.case_name},
                       {"run", result.run},
                       {"kind", result.kind},
                       {"equation", result.equation},
                       {"expected", number_or_text(result.expected_number, result.expected)},
                       {"got", number_or_text(result.got_number, result.got)},
                       {"difference", number(result.difference)},
                       {"tolerance", result.tolerance},
                       {"unit", result.unit},
                       {"reason", result.reason},
                       {"verdict", result.skipped ? "skipped" : (result.ok ? "ok" : "failed")},
                       {"detail", result.detail},
                       {"seconds", result.seconds},
                       {"kept", result.kept},
                       {"version", build.version},
                       {"commit", build.commit},
                       {"compiler", build.compiler},
                       {"cpu", build.cpu}};
        for (const ColumnResult& column : result.columns)
            record["columns"].push_back({{"column", column.column},
                                         {"scaled", number(column.scaled)},
                                         {"difference", number(column.difference)},
                                         {"scale", column.scale},
                                         {"time", column.time}});
        out.push_back(std::move(record));
    }
    return out;
}

}  // namespace type21
