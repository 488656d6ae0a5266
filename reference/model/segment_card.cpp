#include "reference/model/segment_card.h"

#include <algorithm>

#include <fmt/format.h>

#include "reference/model/degenerate_quad.h"

namespace type21 {

ShellFinder::ShellFinder(const Model& model) : model_(model), begin_(static_cast<size_t>(model.nodes.size()) + 1, 0) {
    const auto each_corner = [&](auto act) {
        for (size_t i = 0; i < model.shells.size(); ++i) {
            const Shell& shell = model.shells[i];
            for (int corner = 0; corner < shell.corners(); ++corner)
                act(static_cast<size_t>(shell.node[static_cast<size_t>(corner)]), static_cast<int>(i));
        }
    };
    each_corner([&](size_t node, int) { ++begin_[node + 1]; });
    for (size_t node = 1; node < begin_.size(); ++node)
        begin_[node] += begin_[node - 1];
    at_node_.resize(begin_.back());
    std::vector<size_t> next = begin_;
    each_corner([&](size_t node, int shell) { at_node_[next[node]++] = shell; });
}

int ShellFinder::find(const Segment& segment) const {
    int best = -1;
    const auto node = static_cast<size_t>(segment.node[0]);
    for (size_t i = begin_[node]; i < begin_[node + 1]; ++i) {
        const int candidate = at_node_[i];
        if (!holds(candidate, segment)) continue;
        if (best < 0 || rank(best) < rank(candidate)) best = candidate;
    }
    return best;
}

bool ShellFinder::holds(int shell, const Segment& segment) const {
    const auto& nodes = model_.shells[static_cast<size_t>(shell)].node;
    return std::all_of(segment.node.begin(), segment.node.end(),
                       [&](int node) { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); });
}

std::pair<double, double> ShellFinder::rank(int index) const {
    const Shell& shell = model_.shells[static_cast<size_t>(index)];
    const int material = model_.parts[static_cast<size_t>(shell.part)].material;
    return {shell.thickness, material < 0 ? 0 : model_.materials[static_cast<size_t>(material)].young};
}

std::optional<Segment> read_segment(const Model& model, CardReader& reader, size_t line, std::array<Id, 4> ids,
                                    const ShellFinder& finder) {
    if (!mend_quad(reader, line, ids, "segment", 0)) return std::nullopt;
    Segment segment;
    bool complete = true;
    for (size_t corner = 0; corner < 4; ++corner) {
        const auto found = model.nodes.index.find(ids[corner]);
        if (found != model.nodes.index.end()) {
            segment.node[corner] = found->second;
            continue;
        }
        complete = false;
        if (corner == 3 && ids[3] == ids[2]) continue;
        reader.error(static_cast<int>(line), "node_ID", fmt::format("{}", ids[corner]), "there is no node with this id",
                     "Add it to /NODE, or correct the id");
    }
    if (!complete) return std::nullopt;
    segment.shell = finder.find(segment);
    return segment;
}

}  // namespace type21
