#include "verification/performance/accuracy/query_scene.h"

#include <array>
#include <cmath>

#include "verification/decisions/question_families/question_family.h"
#include "verification/decisions/question_families/tool_shapes.h"

namespace type21::accuracy {

namespace {

constexpr int side = 40;  // quads of a tool along each side
constexpr int middle = side / 2;
constexpr double pitch = 1.1;        // of the tool [mm]
constexpr double radius = 200;       // of a gently curved tool: like a body panel [mm]
constexpr double gap = 0.5;          // and DEPTH [mm]
constexpr double way = 0.002;        // of a node in a cycle: 0.5 m/s at 4 us [mm]
constexpr double limit_share = 0.9;  // of the tool that nodes lie over: none touches its border

using Height = double (*)(double x, double y);

double flat(double, double) {
    return 0;
}
double bowl(double x, double y) {
    return (x * x + y * y) / (2 * radius);
}

DecisionTool tool_of(Height height) {
    DecisionTool tool = sheet(side, side, [&](int i, int j) {
        const double x = pitch * (i - middle), y = pitch * (j - middle);
        return Vec3(x, y, height(x, y));
    });
    set_normals(tool);
    return tool;
}

/// Nodes anywhere over the tool, from DEPTH below to twice the gap above it.
std::vector<QueryBlock> random_over(Height height, const char* name, size_t count, std::uint64_t seed) {
    Draw draw(name, seed, 0);
    const double reach = limit_share * pitch * side / 2;
    std::vector<QueryBlock> blocks{{tool_of(height), {}, {}}};
    for (size_t i = 0; i < count; ++i) {
        const double x = draw.between(-reach, reach);
        const double y = draw.between(-reach, reach);
        const double z = draw.between(-0.8 * gap, 2 * gap);
        blocks[0].queries.push_back({{x, y, height(x, y) + z}, gap, gap, 0});
        blocks[0].before.emplace_back(x - way, y, height(x, y) + z + way);
    }
    return blocks;
}

/// The nodes of a structured blank of half the tool's pitch, right above nodes, edges and centres of the tool, like a
/// blank before it slides; every eighth one after it has slid by a decimal part of the pitch.
std::vector<QueryBlock> mesh_over(Height height, const char* name, size_t count, std::uint64_t seed) {
    Draw draw(name, seed, 0);
    const int columns = static_cast<int>(limit_share * side);
    std::vector<QueryBlock> blocks{{tool_of(height), {}, {}}};
    for (size_t i = 0; i < count; ++i) {
        const int column = draw.below(2 * columns) - columns, row = draw.below(2 * columns) - columns;
        const double slid = draw.chance(0.125) ? 0.1 * pitch * draw.below(10) : 0.0;
        const double x = 0.5 * pitch * column + slid, y = 0.5 * pitch * row;
        const double z = draw.one_of({0.2, 0.4, 0.45, 0.49});
        blocks[0].queries.push_back({{x, y, height(x, y) + z}, gap, gap, 0});
        blocks[0].before.emplace_back(x - way, y, height(x, y) + z + way);
    }
    return blocks;
}

std::vector<QueryBlock> random_flat(size_t count, std::uint64_t seed) {
    return random_over(flat, "random_flat", count, seed);
}
std::vector<QueryBlock> random_bowl(size_t count, std::uint64_t seed) {
    return random_over(bowl, "random_bowl", count, seed);
}
std::vector<QueryBlock> mesh_flat(size_t count, std::uint64_t seed) {
    return mesh_over(flat, "mesh_flat", count, seed);
}
std::vector<QueryBlock> mesh_bowl(size_t count, std::uint64_t seed) {
    return mesh_over(bowl, "mesh_bowl", count, seed);
}

/// All question families in turn, as many blocks of each as the count allows, at least one.
std::vector<QueryBlock> all_families(size_t count, std::uint64_t seed) {
    std::vector<QueryBlock> blocks;
    const size_t rounds = std::max<size_t>(1, count / (question_families().size() * queries_per_block));
    for (std::uint64_t round = 0; round < rounds; ++round) {
        for (const QuestionFamily& family : question_families()) {
            DecisionBlock block = block_of(family, seed, round);
            std::vector<Vec3> before;
            before.reserve(block.queries.size());
            for (const ContactQuery& query : block.queries)
                before.push_back(query.point);
            blocks.push_back({std::move(block.tool), std::move(block.queries), std::move(before)});
        }
    }
    return blocks;
}

}  // namespace

std::span<const SceneKind> scene_kinds() {
    static constexpr std::array<SceneKind, 5> all{{
        {"random_flat", "easy", "nodes anywhere over a flat tool", random_flat},
        {"random_bowl", "easy", "nodes anywhere over a gently curved tool", random_bowl},
        {"mesh_flat", "common", "a structured blank of half the pitch on a structured flat tool", mesh_flat},
        {"mesh_bowl", "common", "the same blank, bent onto a structured, gently curved tool", mesh_bowl},
        {"adversarial", "adversarial", "all question families: ties, slivers, folds, huge and tiny numbers",
         all_families},
    }};
    return all;
}

const SceneKind* scene_named(std::string_view name) {
    for (const SceneKind& kind : scene_kinds())
        if (kind.name == name) return &kind;
    return nullptr;
}

}  // namespace type21::accuracy
