#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "verification/performance/bench/generated.h"
#include "verification/support/scene_builder.h"

namespace type21::bench {

namespace {

/// From 0 to 1 with two derivatives that vanish at both ends.
double step_of(double t) {
    t = std::clamp(t, 0.0, 1.0);
    return t * t * t * (t * (6 * t - 15) + 10);
}

/// The nodes of a square of n quads a side with its middle at 0, row by row.
template <class Put>
void for_grid(int n, double size, const Put& put) {
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            put(size * (double(i) / n - 0.5), size * (double(j) / n - 0.5));
}

constexpr double length = 2000, width = 1400;  // [mm]

/// Signed distance from a rectangle with round corners, then a wall of 160 mm, and two beads on the floor.
double pan_height(double x, double y) {
    constexpr double corner = 200, wall = 160, deep = 80;
    const double dx = std::abs(x) - (length / 2 - 150 - corner), dy = std::abs(y) - (width / 2 - 150 - corner);
    const double outside = std::hypot(std::max(dx, 0.0), std::max(dy, 0.0)) + std::min(std::max(dx, dy), 0.0) - corner;
    const double floor = 1 - step_of((outside + wall) / wall);
    const double bead =
        12 * step_of(1 - std::abs(std::abs(y) - 180) / 70) * step_of((length / 2 - 500 - std::abs(x)) / 150);
    return -deep * floor + bead * floor;
}

}  // namespace

size_t BenchScene::sub_triangles() const {
    size_t count = 0;
    for (const Segment& segment : segments())
        count += segment.is_triangle() ? 1 : 4;
    return count;
}

BenchScene bowl_bench(int blank, int tool) {
    constexpr double blank_size = 110, tool_size = 120;  // [mm]
    GeneratedParts parts;
    parts.edge = blank_size / blank;
    parts.way = Vec3(1, 0, -1);
    parts.speed = 0.1 * std::numbers::sqrt2;  // 100 mm/s in x and in -z
    for_grid(blank, blank_size, [&](double x, double y) { parts.nodes.emplace_back(x, y, 0.0); });
    for_grid(tool, tool_size,
             [&](double x, double y) { parts.tool.emplace_back(x, y, 0.3 + (x * x + y * y) / 40000); });
    parts.blank = grid_segments(blank, blank);
    parts.segments = grid_segments(tool, tool);
    for (auto& corner : parts.segments)
        std::swap(corner[1], corner[3]);  // it looks down on the blank
    BenchScene out = generated(parts);
    out.name = "bowl";
    out.title = "a flat blank in full contact with a bowl that slides over it";
    return out;
}

BenchScene pan_bench(const std::string& name, int triangles, int nodes, double gap) {
    const double cell = std::sqrt(length * width / (0.5 * triangles));
    const int nx = std::max(2, static_cast<int>(std::lround(length / cell)));
    const int ny = std::max(2, static_cast<int>(std::lround(0.5 * triangles / nx)));
    GeneratedParts parts;
    parts.gap = gap;
    parts.edge = std::sqrt(length * width / nodes);
    parts.way = Vec3(1, 0.3, -1);
    const double hx = length / nx, hy = width / ny;
    for (int j = 0; j <= ny; ++j) {
        for (int i = 0; i <= nx; ++i) {
            const auto at = static_cast<std::uint64_t>(j * (nx + 1) + i);
            const double x = hx * (i + 0.15 * noise(at, 0)) - length / 2,
                         y = hy * (j + 0.15 * noise(at, 1)) - width / 2;
            parts.tool.emplace_back(x, y, pan_height(x, y));
        }
    }
    for (int j = 0; j < ny; ++j) {
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + 1, c = b + nx + 1, d = a + nx + 1;
            if ((i + j) % 2 == 0) {
                parts.segments.push_back({a, b, c, c});
                parts.segments.push_back({a, c, d, d});
            } else {
                parts.segments.push_back({a, b, d, d});
                parts.segments.push_back({b, c, d, d});
            }
        }
    }
    for (int k = 0; k < nodes; ++k) {
        const auto at = static_cast<std::uint64_t>(k);
        const auto pick = static_cast<size_t>(k) * parts.segments.size() / static_cast<size_t>(nodes);
        const auto& s = parts.segments[pick];
        const Vec3& a = parts.tool[static_cast<size_t>(s[0])];
        const Vec3 ab = parts.tool[static_cast<size_t>(s[1])] - a, ac = parts.tool[static_cast<size_t>(s[2])] - a;
        double b = 0.5 + 0.5 * noise(at, 2), c = 0.5 + 0.5 * noise(at, 3);
        if (b + c > 1) {
            b = 1 - b;
            c = 1 - c;
        }
        parts.nodes.push_back(a + b * ab + c * ac + 1.9 * noise(at, 4) * ab.cross(ac).normalized());
    }
    BenchScene out = generated(parts);
    out.name = name;
    out.title =
        fmt::format("nodes within 2 mm of a stamped pan of {} triangles, gap {:g} mm", parts.segments.size(), gap);
    return out;
}

BenchScene ties_bench(int n) {
    GeneratedParts parts;
    parts.edge = 4;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i)
            parts.tool.emplace_back(8.0 * i, 8.0 * j, 0.0);
    parts.segments = grid_segments(n, n);
    for (int j = 1; j < 2 * n; ++j)
        for (int i = 1; i < 2 * n; ++i)
            parts.nodes.emplace_back(4.0 * i, 4.0 * j, 0.25);
    parts.way = Vec3(0, 0, 1);
    BenchScene out = generated(parts);
    out.name = "ties";
    out.title = "a structured mesh right above a structured mesh";
    out.kind = "ties";
    return out;
}

int count_of(const std::string& word, int low, int high) {
    int value = 0;
    const char* const end = word.data() + word.size();
    const auto [rest, error] = std::from_chars(word.data(), end, value);
    const std::string suffix(rest, end);
    const long factor = suffix.empty() ? 1 : (suffix == "k" ? 1000 : (suffix == "M" ? 1000000 : 0));
    const long count = factor * value;
    if (error != std::errc() || factor == 0)
        throw std::invalid_argument(fmt::format(
            "'{}' is not a count: a whole number is asked for, with k for thousands or M for millions", word));
    if (count < low || count > high)
        throw std::invalid_argument(fmt::format("{} is outside {} to {}", word, short_count(low), short_count(high)));
    return static_cast<int>(count);
}

std::string short_count(int count) {
    if (count != 0 && count % 1000000 == 0) return fmt::format("{}M", count / 1000000);
    if (count != 0 && count % 1000 == 0) return fmt::format("{}k", count / 1000);
    return fmt::format("{}", count);
}

}  // namespace type21::bench
