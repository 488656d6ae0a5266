// Hard queries: the shape of single segments.
#include <array>

#include "verification/decisions/question_families/node_positions.h"
#include "verification/decisions/question_families/question_family.h"
#include "verification/decisions/question_families/tool_shapes.h"

namespace type21 {

DecisionBlock make_slivers(Draw& draw) {
    const double thin = draw.chance(0.1) ? 0.0 : draw.power_of_two(-60, -1);
    const double bent = draw.one_of({0.0, 0.01, 0.01 * draw.unit()});
    const double shear = draw.one_of({0.0, 0.0, draw.between(-1, 1)});
    DecisionBlock block;
    block.tool = sheet(3, 2, [&](int i, int j) { return Vec3(i + shear * j * thin, thin * j, bent * i * i); });
    // A needle: one corner drawn onto the line of its neighbours.
    if (draw.chance(0.3)) {
        const size_t corner = static_cast<size_t>(draw.below(static_cast<int>(block.tool.node.size())));
        block.tool.node[corner].y() = draw.one_of({0.0, 0.5 * thin, moved(thin, 1)});
    }
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.5, 1.0}));
    set_normals(block.tool);
    add_queries(draw, block, draw.one_of({1.0, thin > 0 ? thin : 1.0}), queries_per_block);
    return block;
}

DecisionBlock make_quads(Draw& draw) {
    const double warp = draw.one_of({0.0, 0.01, 0.3, 1.0, 4.0});
    DecisionBlock block;
    DecisionTool& tool = block.tool;
    tool = sheet(2, 2, [&](int i, int j) { return Vec3(i, j, warp * draw.between(-1, 1)); });
    auto& corner = tool.segment[static_cast<size_t>(draw.below(4))];
    const auto x = [&](size_t j) -> Vec3& { return tool.node[static_cast<size_t>(corner[j])]; };
    switch (draw.below(6)) {
        case 0:  // crossed like a bow tie
            std::swap(corner[1], corner[2]);
            break;
        case 1:  // folded along its diagonal
            x(1) = x(3) + 0.01 * draw.in_cube();
            break;
        case 2:  // two corners in one place, by two nodes
            x(1) = x(0);
            break;
        case 3:  // all corners on a line
            x(1) = x(0) + 0.25 * (x(2) - x(0));
            x(3) = x(0) + 0.5 * (x(2) - x(0));
            break;
        case 4:  // a corner beyond the opposite diagonal
            x(2) = 0.5 * x(1) + 0.5 * x(3) + draw.unit() * 0.5 * (x(0) - x(1));
            break;
        default:
            break;
    }
    set_normals(tool);
    add_queries(draw, block, 1, queries_per_block);
    return block;
}

DecisionBlock make_high_aspect(Draw& draw) {
    const double length = draw.one_of({1e9, 1e9 * draw.unit(), 0x1p30});
    const double lean = draw.one_of({0.0, draw.between(-1, 1)});
    DecisionBlock block;
    block.tool = sheet(2, 3, [&](int i, int j) { return Vec3(length * i + lean * j, j, lean * 0.1 * j * j); });
    halve_quads(block.tool, draw, draw.one_of({0.0, 1.0}));
    set_normals(block.tool);
    add_queries(draw, block, 1, queries_per_block);
    return block;
}

DecisionBlock make_one_triangle(Draw& draw) {
    DecisionBlock block;
    for (int i = 0; i < 3; ++i)
        block.tool.node.push_back(draw.in_cube());
    block.tool.segment = {{0, 1, 2, 2}};
    set_normals(block.tool);
    const double lean = draw.one_of({0.0, 0.1, 1.0, 3.0});
    if (lean > 0)
        for (Vec3& n : block.tool.normal)
            n = unit_vector(n + lean * draw.in_cube());
    add_queries(draw, block, 1, queries_per_block);
    return block;
}

DecisionBlock make_leaning_normals(Draw& draw) {
    DecisionBlock block;
    DecisionTool& tool = block.tool;
    tool = sheet(2, 2, [&](int i, int j) { return Vec3(i, j, 0.1 * draw.between(-1, 1)); });
    halve_quads(tool, draw, draw.one_of({0.0, 0.5}));
    set_normals(tool);
    for (size_t j = 0; j < tool.normal.size(); ++j) {
        Vec3& n = tool.normal[j];
        switch (draw.below(8)) {
            case 0:
                n = -n;
                break;
            case 1:
                n = Vec3::Zero();
                break;
            case 2:  // in the plane of the sheet: the slope is zero or nearly so
                n = Vec3(draw.sign(), 0, 0);
                break;
            case 3:  // cancels the one before
                n = j > 0 ? Vec3(-tool.normal[j - 1]) : n;
                break;
            case 4:
                n = unit_vector(n + 2 * draw.in_cube());
                break;
            default:
                break;
        }
    }
    add_queries(draw, block, 1, queries_per_block);
    return block;
}

DecisionBlock make_soup(Draw& draw) {
    constexpr int nodes = 9;
    DecisionBlock block;
    for (int i = 0; i < nodes; ++i) {
        block.tool.node.push_back(draw.in_cube());
        block.tool.normal.push_back(unit_vector(draw.in_cube()));
    }
    for (int s = 0; s < 6; ++s) {
        std::array<int, 4> corner{};
        for (int& c : corner)
            c = draw.below(nodes);
        if (draw.chance(0.5)) corner[3] = corner[2];
        block.tool.segment.push_back(corner);
    }
    // Normals that have something to do with the segments, or not.
    if (draw.chance(0.7)) set_normals(block.tool);
    add_queries(draw, block, 1, queries_per_block);
    return block;
}

}  // namespace type21
