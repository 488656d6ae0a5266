#include "verification/results/record/effect_files.h"

#include <fmt/format.h>

namespace type21 {

EffectFiles::EffectFiles(const HostScene& scene, int interface, const std::filesystem::path& folder)
    : model_(*scene.host), interface_(interface) {
    const Interface& card = model_.interfaces[static_cast<size_t>(interface)];
    if (scene.has(interface, Effect::skid_line)) {
        skid_.emplace(folder / fmt::format("skid_line_{}.csv", card.id),
                      std::vector<std::string>{"time", "node", "skid"});
        largest_skid_.assign(static_cast<size_t>(card.secondary.size()), 0.0);
    }
    if (scene.has(interface, Effect::adaptive_data)) {
        adaptive_.emplace(
            folder / fmt::format("adaptive_{}.csv", card.id),
            std::vector<std::string>{"time", "element", "radius", "longest_edge", "cosine", "penetration"});
        divided_.assign(model_.surfaces[static_cast<size_t>(card.secondary_surface)].segments.size(), 0);
    }
}

void EffectFiles::observe(const CycleRecord& record) {
    const ContactStep& step = (*record.contacts)[static_cast<size_t>(interface_)];
    if (skid_) {
        if (!step.skid.empty()) largest_skid_ = step.skid;
        if (record.last) write_skid_line(record.time);
    }
    if (adaptive_) write_adaptive(record, step);
}

void EffectFiles::write_skid_line(double time) {
    const auto& nodes = model_.interfaces[static_cast<size_t>(interface_)].secondary.node;
    for (size_t n = 0; n < nodes.size(); ++n)
        skid_->row(digits17(time), model_.nodes.id[static_cast<size_t>(nodes[n])], {largest_skid_[n]});
}

void EffectFiles::write_adaptive(const CycleRecord& record, const ContactStep& step) {
    const Interface& card = model_.interfaces[static_cast<size_t>(interface_)];
    const auto& segments = model_.surfaces[static_cast<size_t>(card.secondary_surface)].segments;
    for (size_t e = 0; e < step.adaptive.size(); ++e) {
        const AdaptiveElement& element = step.adaptive[e];
        if (!element.divide || divided_[e] != 0) continue;
        divided_[e] = 1;
        const int shell = segments[e].shell;
        const Id id = shell < 0 ? -static_cast<Id>(e) - 1 : model_.shells[static_cast<size_t>(shell)].id;
        adaptive_->row(digits17(record.time), id,
                       {element.radius, element.longest_edge, element.cosine, element.penetration});
    }
}

std::vector<CsvWriter*> EffectFiles::files() {
    std::vector<CsvWriter*> files;
    for (std::optional<CsvWriter>* file : {&skid_, &adaptive_})
        if (*file) files.push_back(&**file);
    return files;
}

}  // namespace type21
