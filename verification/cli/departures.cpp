#include <fmt/format.h>

#include "reference/model/as_built.h"
#include "verification/cli/verbs.h"

namespace type21::cli {

void add_departures(CLI::App& app, int&) {
    CLI::App* verb = app.add_subcommand(
        "departures", "Where the public OpenRadioss does something else than the page: what --as-built takes");
    verb->callback([] {
        for (const DepartureRow& row : departures()) {
            fmt::print("{}  {}\n     page      {}\n     as built  {}\n", name(row.id),
                       row.available ? "available" : "not available", row.page, row.as_built);
            if (!row.reason.empty()) fmt::print("     because   {}\n", row.reason);
        }
        fmt::print("--as-built all switches on: {}\n", AsBuilt::all().text());
    });
}

}  // namespace type21::cli
