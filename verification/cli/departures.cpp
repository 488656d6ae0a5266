#include "reference/contract/departures.h"

#include <memory>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "verification/cli/exit_code.h"
#include "verification/cli/verbs.h"

namespace type21::cli {

namespace {

nlohmann::ordered_json departures_json() {
    nlohmann::ordered_json out = nlohmann::ordered_json::array();
    for (const DepartureRow& row : departures())
        out.push_back({{"id", name(row.id)},
                       {"available", row.available},
                       {"documented", row.documented},
                       {"as_built", row.as_built},
                       {"reason", row.reason}});
    return out;
}

}  // namespace

void add_departures(CLI::App& app, int&) {
    CLI::App* verb = app.add_subcommand(
        "departures",
        "List the differences between the manual page and the public OpenRadioss, which --as-built switches on");
    const auto json = std::make_shared<std::string>();
    verb->add_option("--json", *json, "also write the list to this JSON file");
    verb->callback([json] {
        if (!json->empty()) write_report(*json, departures_json());
        for (const DepartureRow& row : departures()) {
            fmt::print("{}  {}\n     documented  {}\n     as built    {}\n", name(row.id),
                       row.available ? "available" : "not available", row.documented, row.as_built);
            if (!row.reason.empty()) fmt::print("     because     {}\n", row.reason);
        }
        fmt::print("--as-built all switches on: {}\n", AsBuilt::all().text());
    });
}

}  // namespace type21::cli
