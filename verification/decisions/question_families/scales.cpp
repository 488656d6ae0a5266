// Hard queries: the size of the numbers.
#include <cmath>

#include "verification/decisions/question_families/node_positions.h"
#include "verification/decisions/question_families/question_family.h"
#include "verification/decisions/question_families/tool_shapes.h"

namespace type21 {

namespace {

/// A gently curved sheet of unit pitch, quads and triangles.
DecisionTool curved_sheet(Draw& draw) {
    const double bend = draw.one_of({0.0, 0.05, -0.05, 0.5});
    DecisionTool tool = sheet(3, 3, [&](int i, int j) { return Vec3(i, j, bend * (i * i + 0.5 * i * j)); });
    halve_quads(tool, draw, draw.one_of({0.0, 0.5}));
    return tool;
}

}  // namespace

DecisionBlock make_tiny_gap(Draw& draw) {
    const double far = draw.one_of({0.0, 1e6, 1e9});
    const double size = draw.one_of({1.0, 1.3, 1e-3});
    DecisionBlock block;
    block.tool = curved_sheet(draw);
    place_at(block.tool, size, Vec3(far, -far, far));
    set_normals(block.tool);
    for (int i = 0; i < queries_per_block; ++i) {
        const QueryReach reach{1e-9, draw.one_of({1e-9, 2e-9, 1e-6}), draw.one_of({0.0, 2e-9})};
        block.queries.push_back(query_near(draw, block.tool, reach));
    }
    return block;
}

DecisionBlock make_far_away(Draw& draw) {
    const double far = draw.one_of({1e6, 1e9, 0x1p40});
    const double ulp = std::nextafter(far, 2 * far) - far;
    const double size = ulp * draw.power_of_two(0, 17);
    DecisionBlock block;
    block.tool = curved_sheet(draw);
    const Vec3 corner = draw.in_cube().cwiseSign();
    place_at(block.tool, size, far * corner);
    set_normals(block.tool);
    add_queries(draw, block, size, queries_per_block);
    return block;
}

DecisionBlock make_extreme_scales(Draw& draw) {
    const double scale = draw.one_of({1e150, 1e-150, 1e100, 1e-100, 1e60, 1e-60, 1e30, 1e-30});
    DecisionBlock block;
    block.tool = curved_sheet(draw);
    place_at(block.tool, scale, Vec3::Zero());
    set_normals(block.tool);
    // Both ends in one tool: a height that is nothing beside the width.
    if (draw.chance(0.2)) block.tool.node[5].z() = draw.one_of({1e-150, 1e-300, 0.0});
    add_queries(draw, block, scale, queries_per_block);
    return block;
}

DecisionBlock make_denormals(Draw& draw) {
    // 0x1p-1074 is the smallest double; segments of 8 to 2^20 of them.
    const double size = std::ldexp(draw.power_of_two(3, 20), -1074);
    DecisionBlock block;
    block.tool = curved_sheet(draw);
    place_at(block.tool, size, Vec3::Zero());
    set_normals(block.tool);
    if (draw.chance(0.3))  // a denormal normal
        block.tool.normal[static_cast<size_t>(draw.below(16))] = Vec3(0, 0, 0x1p-1070);
    add_queries(draw, block, size, queries_per_block);
    return block;
}

}  // namespace type21
