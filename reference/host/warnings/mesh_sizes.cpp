/// @file Tool segments smaller than those of the blank: the nodes of the blank step over what the tool resolves.
#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "reference/host/warnings/warnings.h"

namespace type21 {
namespace {

/// Two meshes count as equally fine up to this ratio: tools are meshed somewhat finer than blanks, and sizes vary.
constexpr double equally_fine = 0.7;

/// Median of the side of the square (of a triangle: half of the square) that has the area of a segment [length].
double middle_size(const Surface& surface, const std::vector<Vec3>& x) {
    std::vector<double> sizes;
    sizes.reserve(surface.segments.size());
    for (const Segment& segment : surface.segments) {
        const auto at = [&](size_t corner) -> const Vec3& { return x[static_cast<size_t>(segment.node[corner])]; };
        const double area = 0.5 * (at(2) - at(0)).cross(at(3) - at(1)).norm();
        sizes.push_back(std::sqrt(segment.is_triangle() ? 2.0 * area : area));
    }
    if (sizes.empty()) return 0;
    const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
    std::nth_element(sizes.begin(), middle, sizes.end());
    return *middle;
}

}  // namespace

void warn_of_fine_tools(const SurpriseCheck& check) {
    const auto& x = check.model.nodes.position;
    for (const Interface& interface : check.model.interfaces) {
        const double tool = middle_size(check.main_surface(interface), x);
        const double blank = middle_size(check.secondary_surface(interface), x);
        if (!(tool < equally_fine * blank)) continue;
        check.at_interface(interface, "surf_IDm", fmt::format("{} (median size)", check.quantity(tool, dim::length)),
                           fmt::format("the segments of the tool are smaller than those of the blank, {}: only "
                                       "nodes of the blank meet the tool, so what lies between two of them is not felt",
                                       check.quantity(blank, dim::length)),
                           "Refine the blank where the tool is finer, or coarsen the tool");
    }
}

}  // namespace type21
