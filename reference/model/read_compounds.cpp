#include <utility>

#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

/// A set that is made of others.
struct Compound {
    int index = -1;  ///< in the model
    Id id = 0;
    CardReader reader;
    std::vector<std::pair<int, bool>> from;  ///< entry, turned
    size_t waits_for = 0;                    ///< entries of `from` that are compounds and not complete yet
    double members = 0;                      ///< how many plain sets it is made of, each as often as it is named
};

/// A chain in which every set names the next one twice doubles at each link; no deck means that.
constexpr double most_members = 1e6;

}  // namespace

/// Every compound is made when the last of its members is complete, so the work is proportional to what is listed,
/// however long a chain of sets is. What is left over in the end contains itself.
void read_compounds(Reading& reading, Keyword keyword, Registry& registry, const std::function<int()>& next,
                    const std::function<void(const CardReader&, Id)>& start,
                    const std::function<void(int index, int from, bool turned)>& append,
                    const std::function<void(int index)>& finish) {
    const std::string field = registry.keyword.substr(1) + "_ID";
    const int first = next();
    std::vector<Compound> compounds;
    reading.each(keyword, registry, next, [&](CardReader& reader, Id id) {
        compounds.push_back({next(), id, reader, {}, 0, 0});
        start(reader, id);
    });
    std::vector<std::vector<size_t>> waiting(compounds.size());  // by compound: those that list it
    std::vector<size_t> ready;
    for (size_t c = 0; c < compounds.size(); ++c) {
        Compound& compound = compounds[c];
        for (const ListedId& listed : listed_ids(compound.reader, 1, field)) {
            const Id id = listed.id < 0 ? -listed.id : listed.id;
            const int from = reading.member(compound.reader, listed.line, field, id, registry, true);
            if (from < 0) continue;
            compound.from.emplace_back(from, listed.id < 0);
            if (from < first) continue;
            waiting[static_cast<size_t>(from - first)].push_back(c);
            ++compound.waits_for;
        }
        if (compound.waits_for == 0) ready.push_back(c);
    }
    std::vector<char> made(compounds.size(), 0);
    for (size_t i = 0; i < ready.size(); ++i) {
        Compound& compound = compounds[ready[i]];
        for (const auto& [from, turned] : compound.from)
            compound.members += from < first ? 1 : compounds[static_cast<size_t>(from - first)].members;
        if (compound.members > most_members) {
            compound.reader.error(
                -1, field, fmt::format("{}", compound.id),
                fmt::format("the set is made of more than {:.0f} others, one way or another", most_members),
                "Name each set once");
            compound.members = 0;
            compound.from.clear();
        }
        for (const auto& [from, turned] : compound.from)
            append(compound.index, from, turned);
        if (finish) finish(compound.index);
        made[ready[i]] = 1;
        for (const size_t other : waiting[ready[i]]) {
            if (--compounds[other].waits_for == 0) ready.push_back(other);
        }
    }
    for (size_t c = 0; c < compounds.size(); ++c) {
        if (made[c] != 0) continue;
        compounds[c].reader.error(-1, field, fmt::format("{}", compounds[c].id),
                                  "a set does not contain itself, directly or through others", "Remove one of the ids");
    }
}

}  // namespace type21
