#include "selecting.h"

#include <fmt/format.h>

namespace type21::test {

std::string list_card(const std::string& keyword, const std::vector<std::string>& ids) {
    return keyword + "\nt\n" + ints(ids);
}

Selecting::Selecting(const std::string& starter) {
    deck_ = read_deck({MemoryFile{"scene_0000.rad", starter}}, problems);
    reading_ = std::make_unique<Reading>(deck_, model, problems);
    read_begin(*reading_);
    check_keywords(*reading_);
    read_skews(*reading_);
    read_functions(*reading_);
    read_materials(*reading_);
    read_mesh(*reading_);
    read_selections(*reading_);
}

std::vector<Segment> Selecting::surface(Id id) {
    const SelectionCard* card = reading_->selector->cards().find(Family::surface, id);
    return card == nullptr ? std::vector<Segment>{} : reading_->selector->segments(*card);
}

std::string Selecting::segments(Id id) {
    std::string text;
    for (const Segment& segment : surface(id)) {
        std::vector<Id> ids;
        for (const int node : segment.node)
            ids.push_back(model.nodes.id[static_cast<size_t>(node)]);
        text += fmt::format("{}{}", text.empty() ? "" : ", ", fmt::join(ids, " "));
    }
    return text;
}

std::vector<Id> Selecting::nodes(Id grnod) {
    std::vector<Id> ids;
    const int group = reading_->groups.find(grnod);
    if (group < 0) return ids;
    for (const int node : model.groups[static_cast<size_t>(group)].nodes)
        ids.push_back(model.nodes.id[static_cast<size_t>(node)]);
    return ids;
}

std::vector<Id> Selecting::shell_ids(Family family, ShellKind kind, Id id) {
    std::vector<Id> ids;
    const SelectionCard* card = reading_->selector->cards().find(family, id);
    if (card == nullptr) return ids;
    for (const int shell : reading_->selector->shells(*card, kind))
        ids.push_back(model.shells[static_cast<size_t>(shell)].id);
    return ids;
}

std::vector<Id> Selecting::shells(Id grshel) {
    return shell_ids(Family::shell_group, ShellKind::shell, grshel);
}

std::vector<Id> Selecting::sh3n(Id grsh3n) {
    return shell_ids(Family::sh3n_group, ShellKind::sh3n, grsh3n);
}

std::vector<Id> Selecting::parts(Id grpart) {
    std::vector<Id> ids;
    const SelectionCard* card = reading_->selector->cards().find(Family::part_group, grpart);
    if (card == nullptr) return ids;
    for (const int part : reading_->selector->parts(*card))
        ids.push_back(model.parts[static_cast<size_t>(part)].id);
    return ids;
}

}  // namespace type21::test
