#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

struct Compound {
    int index = -1;  ///< in the model
    Id id = 0;
    CardReader reader;
    std::vector<std::pair<int, bool>> from;  ///< entry, turned
};

bool ready(const Compound& compound, const std::vector<bool>& filled) {
    return std::all_of(compound.from.begin(), compound.from.end(),
                       [&](const auto& part) { return filled[static_cast<size_t>(part.first)]; });
}

}  // namespace

void read_compounds(Reading& reading, Keyword keyword, Registry& registry, const std::function<int()>& next,
                    const std::function<void(const CardReader&, Id)>& start,
                    const std::function<void(int index, int from, bool turned)>& append) {
    const std::string field = registry.keyword.substr(1) + "_ID";
    std::vector<bool> filled(static_cast<size_t>(next()), true);
    std::vector<Compound> compounds;
    reading.each(keyword, registry, next, [&](CardReader& reader, Id id) {
        compounds.push_back({next(), id, reader, {}});
        start(reader, id);
        filled.push_back(false);
    });
    for (Compound& compound : compounds) {
        for (const ListedId& listed : listed_ids(compound.reader, 1, field)) {
            const Id id = listed.id < 0 ? -listed.id : listed.id;
            const int from = reading.reference(compound.reader, listed.line, field, id, registry, true);
            if (from >= 0) compound.from.emplace_back(from, listed.id < 0);
        }
    }
    size_t left = compounds.size();
    for (bool progress = true; progress && left > 0;) {
        progress = false;
        for (const Compound& compound : compounds) {
            if (filled[static_cast<size_t>(compound.index)] || !ready(compound, filled)) continue;
            for (const auto& [from, turned] : compound.from)
                append(compound.index, from, turned);
            filled[static_cast<size_t>(compound.index)] = true;
            progress = true;
            --left;
        }
    }
    for (Compound& compound : compounds) {
        if (filled[static_cast<size_t>(compound.index)]) continue;
        compound.reader.error(-1, field, fmt::format("{}", compound.id),
                              "a set does not contain itself, directly or through others", "Remove one of the ids");
    }
}

}  // namespace type21
