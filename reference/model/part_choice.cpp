#include "reference/model/part_choice.h"

#include <unordered_set>

#include <fmt/format.h>

#include "reference/model/reading.h"
#include "reference/model/selection_cards.h"

namespace type21 {

bool PartChoice::knows(std::string_view type) {
    return type == "PART" || type == "MAT" || type == "PROP" || type == "SUBSET";
}

void PartChoice::append(CardReader& reader, size_t line, std::string_view type, Id id, std::vector<int>& parts) {
    const auto append_where = [&](std::string_view field, const Registry& registry, int Part::*member) {
        const int wanted = reading_.reference(reader, line, field, id, registry, true);
        if (wanted < 0) return;
        for (size_t i = 0; i < reading_.model.parts.size(); ++i) {
            if (reading_.model.parts[i].*member == wanted) parts.push_back(static_cast<int>(i));
        }
    };
    if (type == "PART") {
        const int part = reading_.reference(reader, line, "part_ID", id, reading_.parts, true);
        if (part >= 0) parts.push_back(part);
    } else if (type == "MAT") {
        append_where("mat_ID", reading_.materials, &Part::material);
    } else if (type == "PROP") {
        append_where("prop_ID", reading_.properties, &Part::property);
    } else {
        append_subset(reader, line, id, parts);
    }
}

void PartChoice::append_subset(CardReader& reader, size_t line, Id id, std::vector<int>& parts) {
    if (!subsets_known_) {
        for (size_t i = 0; i < reading_.part_subsets.size(); ++i) {
            const Id subset = reading_.part_subsets[i];
            if (subset != 0) parts_of_subset_[subset].push_back(static_cast<int>(i));
        }
        subsets_known_ = true;
    }
    const auto unknown = [](CardReader& where, size_t at, Id missing) {
        where.error(static_cast<int>(at), "subset_ID", fmt::format("{}", missing), "there is no /SUBSET with this id",
                    "Add the /SUBSET card, or correct the id");
    };
    const SelectionCard* card = cards_.find(Family::subset, id);
    if (card == nullptr) {
        unknown(reader, line, id);
        return;
    }
    // A subset that is reached twice counts once, so that subsets which list each other end, too.
    std::unordered_set<Id> reached{id};
    std::vector<const SelectionCard*> open{card};
    while (!open.empty()) {
        const SelectionCard* subset = open.back();
        open.pop_back();
        if (const auto own = parts_of_subset_.find(subset->id); own != parts_of_subset_.end())
            parts.insert(parts.end(), own->second.begin(), own->second.end());
        CardReader list = reading_.reader(*subset->card, subset->unit_word);
        list.need({"title"});
        const std::vector<ListedId> children = listed_ids(list, 1, "subset_ID");
        list.finish();
        for (const ListedId& listed : children) {
            const SelectionCard* child = cards_.find(Family::subset, listed.id);
            if (child == nullptr) {
                unknown(list, listed.line, listed.id);
            } else if (reached.insert(listed.id).second) {
                open.push_back(child);
            }
        }
    }
}

}  // namespace type21
