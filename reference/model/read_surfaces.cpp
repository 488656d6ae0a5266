#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "reference/model/degenerate_quad.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

/// The same piece seen from its other side.
Segment reversed(const Segment& segment) {
    Segment other = segment;
    if (segment.is_triangle()) {
        std::swap(other.node[0], other.node[1]);
    } else {
        std::reverse(other.node.begin(), other.node.end());
    }
    return other;
}

/// Segments of the shells of the listed parts, in the order of the shells; a negative part id turns them round.
void read_part_surface(Reading& reading, CardReader& reader, Surface& surface) {
    const Model& model = reading.model;
    std::vector<int> sign(model.parts.size(), 0);
    for (const ListedId& listed : listed_ids(reader, 1, "part_ID")) {
        const Id id = listed.id < 0 ? -listed.id : listed.id;
        const int part = reading.reference(reader, listed.line, "part_ID", id, reading.parts, true);
        if (part >= 0) sign[static_cast<size_t>(part)] = listed.id < 0 ? -1 : 1;
    }
    for (size_t i = 0; i < model.shells.size(); ++i) {
        const Shell& shell = model.shells[i];
        const int side = sign[static_cast<size_t>(shell.part)];
        if (side == 0) continue;
        const Segment segment{shell.node, static_cast<int>(i)};
        surface.segments.push_back(side > 0 ? segment : reversed(segment));
    }
}

/// Finds the shell that a segment lies on: it has all nodes of the segment; of several the thickest, then the stiffest.
class ShellFinder {
  public:
    explicit ShellFinder(const Model& model) : model_(model), at_node_(static_cast<size_t>(model.nodes.size())) {
        for (size_t i = 0; i < model.shells.size(); ++i) {
            const Shell& shell = model.shells[i];
            for (int corner = 0; corner < shell.corners(); ++corner) {
                at_node_[static_cast<size_t>(shell.node[static_cast<size_t>(corner)])].push_back(static_cast<int>(i));
            }
        }
    }

    int find(const Segment& segment) const {
        int best = -1;
        for (const int candidate : at_node_[static_cast<size_t>(segment.node[0])]) {
            if (!holds(candidate, segment)) continue;
            if (best < 0 || rank(best) < rank(candidate)) best = candidate;
        }
        return best;
    }

  private:
    bool holds(int shell, const Segment& segment) const {
        const auto& nodes = model_.shells[static_cast<size_t>(shell)].node;
        return std::all_of(segment.node.begin(), segment.node.end(),
                           [&](int node) { return std::find(nodes.begin(), nodes.end(), node) != nodes.end(); });
    }

    std::pair<double, double> rank(int index) const {
        const Shell& shell = model_.shells[static_cast<size_t>(index)];
        const int material = model_.parts[static_cast<size_t>(shell.part)].material;
        return {shell.thickness, material < 0 ? 0 : model_.materials[static_cast<size_t>(material)].young};
    }

    const Model& model_;
    std::vector<std::vector<int>> at_node_;
};

void read_segments(Reading& reading, CardReader& reader, const ShellFinder& finder, Surface& surface) {
    for (size_t line = 1; line < reader.line_count(); ++line) {
        if (reader.blank(line, 1, 60)) continue;
        std::array<Id, 4> ids{};
        reader.unused(line, 1, 10, 10);  // the number of the segment
        for (int corner = 0; corner < 4; ++corner) {
            ids[static_cast<size_t>(corner)] = reader.integer(line, 11 + 10 * corner, 20 + 10 * corner, "node_ID");
        }
        if (!mend_quad(reader, line, ids, "segment", 0)) continue;
        Segment segment;
        bool complete = true;
        for (size_t corner = 0; corner < 4; ++corner) {
            const auto found = reading.model.nodes.index.find(ids[corner]);
            if (found != reading.model.nodes.index.end()) {
                segment.node[corner] = found->second;
                continue;
            }
            complete = false;
            if (corner == 3 && ids[3] == ids[2]) continue;
            reader.error(static_cast<int>(line), "node_ID", fmt::format("{}", ids[corner]),
                         "there is no node with this id", "Add it to /NODE, or correct the id");
        }
        if (!complete) continue;
        segment.shell = finder.find(segment);
        surface.segments.push_back(segment);
    }
}

}  // namespace

/// /SURF/PART, /SURF/SEG and /SURF/SURF.
void read_surfaces(Reading& reading) {
    std::vector<Surface>& surfaces = reading.model.surfaces;
    const auto next = [&] { return static_cast<int>(surfaces.size()); };
    const auto start = [&](const CardReader& reader, Id id) -> Surface& {
        Surface& surface = surfaces.emplace_back();
        surface.id = id;
        surface.title = reader.text(0, 1, 100);
        return surface;
    };
    reading.each(Keyword::surface_part, reading.surfaces, next,
                 [&](CardReader& reader, Id id) { read_part_surface(reading, reader, start(reader, id)); });
    std::optional<ShellFinder> finder;
    reading.each(Keyword::surface_segment, reading.surfaces, next, [&](CardReader& reader, Id id) {
        if (!finder) finder.emplace(reading.model);
        read_segments(reading, reader, *finder, start(reader, id));
    });
    const auto append = [&](int index, int from, bool turned) {
        Surface& surface = surfaces[static_cast<size_t>(index)];
        for (const Segment& segment : surfaces[static_cast<size_t>(from)].segments) {
            surface.segments.push_back(turned ? reversed(segment) : segment);
        }
    };
    read_compounds(reading, Keyword::surface_surface, reading.surfaces, next, start, append);
}

}  // namespace type21
