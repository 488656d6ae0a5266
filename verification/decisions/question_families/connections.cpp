// Hard queries: how segments meet.
#include <algorithm>

#include "verification/decisions/question_families/node_positions.h"
#include "verification/decisions/question_families/question_family.h"
#include "verification/decisions/question_families/tool_shapes.h"

namespace type21 {

namespace {

DecisionTool turned_over(DecisionTool tool) {
    for (auto& corner : tool.segment) {
        if (corner[2] == corner[3])
            corner = {corner[1], corner[0], corner[2], corner[2]};
        else
            std::reverse(corner.begin(), corner.end());
    }
    return tool;
}

/// A fold at x = 0: to the left the strip z = 0, to the right one that goes down (sign -1) or up (+1).
DecisionBlock fold(Draw& draw, double sign) {
    const double inner = draw.one_of({1.0, 10.0, 30.0, 60.0, 89.0, 90.0, 120.0, 150.0, 179.0, draw.between(1, 179)});
    const Turn bend = turn(180 - inner);
    const double pitch = draw.one_of({1.0, 0.1, draw.between(0.1, 2)});
    DecisionBlock block;
    block.tool = drawn_profile(4, 2, pitch, [&](int i) -> Vec3 {
        const double along = pitch * (i - 2);
        if (i <= 2) return {along, 0, 0};
        return {along * bend.cosine, 0, sign * along * bend.sine};
    });
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.0, 0.5, 1.0}));
    set_normals(block.tool);
    add_queries(draw, block, pitch, queries_per_block);
    return block;
}

/// An arc of a cylinder round y; radius > 0: convex and outward up, < 0: a trough that opens upward.
DecisionTool arc(int columns, double radius, double from, double step, double pitch) {
    return drawn_profile(columns, 2, pitch, [&](int i) -> Vec3 {
        const Turn at = turn(from + step * i);
        return {std::abs(radius) * at.sine, 0, radius * at.cosine};
    });
}

}  // namespace

DecisionBlock make_duplicates(Draw& draw) {
    DecisionBlock block;
    DecisionTool& tool = block.tool;
    const double wave = draw.one_of({0.0, 0.1});
    tool = sheet(2, 2, [&](int i, int j) { return Vec3(i, j, wave * draw.between(-1, 1)); });
    halve_quads(tool, draw, draw.one_of({0.0, 0.5}));
    const auto copy = tool.segment[static_cast<size_t>(draw.below(static_cast<int>(tool.segment.size())))];
    switch (draw.below(5)) {
        case 0:  // the same nodes twice
            tool.segment.push_back(copy);
            break;
        case 1:  // the same nodes from another corner on
            tool.segment.push_back(copy[2] == copy[3] ? std::array<int, 4>{copy[1], copy[2], copy[0], copy[0]}
                                                      : std::array<int, 4>{copy[1], copy[2], copy[3], copy[0]});
            break;
        case 2:  // other nodes in the same places
            append(tool, DecisionTool(tool));
            break;
        case 3:  // opposite, same nodes: their normals cancel
            tool.segment.push_back(turned_over({{}, {}, {copy}}).segment[0]);
            break;
        default:  // opposite, nodes of its own
            append(tool, turned_over(tool));
            break;
    }
    set_normals(tool);
    add_queries(draw, block, 1, queries_per_block);
    return block;
}

DecisionBlock make_t_junctions(Draw& draw) {
    const double crack = draw.one_of({0.0, 0x1p-52, 0x1p-30, 0.005, 0.0099, 0.02});
    const double step = draw.one_of({0.0, 0.0, 0x1p-52, 0.01});
    DecisionBlock block;
    block.tool = sheet(2, 2, [](int i, int j) { return Vec3(i - 2, j, 0); });
    append(block.tool, sheet(3, 4, [&](int i, int j) { return Vec3(crack + 0.5 * i, 0.5 * j, step); }));
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.5}));
    set_normals(block.tool);
    for (int i = 0; i < queries_per_block; ++i) {
        const QueryReach reach = reach_for(draw, 1);
        if (draw.chance(0.5)) {
            block.queries.push_back(query_near(draw, block.tool, reach));
            continue;
        }
        const double x = draw.one_of({0.0, crack, 0.5 * crack, -0.005, crack + 0.005});
        const double y = draw.one_of({0.0, 0.25, 0.5, 0.75, 1.0, 2 * draw.unit()});
        const double z = draw.one_of({0.0, step, 0.5 * reach.gap, reach.gap, -reach.depth});
        block.queries.push_back(query_at(nudged(draw, {x, y, z}), reach));
    }
    return block;
}

DecisionBlock make_convex_folds(Draw& draw) {
    return fold(draw, -1);
}

DecisionBlock make_concave_folds(Draw& draw) {
    return fold(draw, +1);
}

DecisionBlock make_medial_axis(Draw& draw) {
    const int columns = 2 * (2 + draw.below(4));
    const double radius = draw.one_of({1.0, 0.1, draw.between(0.5, 2)});
    const double step = draw.one_of({10.0, 15.0, 160.0 / columns});
    const double pitch = draw.one_of({0.5, 0.1}) * radius;
    DecisionBlock block;
    block.tool = arc(columns, -radius, -0.5 * step * columns, step, pitch);
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.0, 1.0}));
    set_normals(block.tool);
    for (int i = 0; i < queries_per_block; ++i) {
        QueryReach reach = reach_for(draw, radius);
        reach.gap = draw.one_of({radius, moved(radius, 1), 1.1 * radius, 0.9 * radius});
        if (draw.chance(0.5)) reach.proximity = 1.5 * radius;
        const double y = draw.one_of({0.0, 0.5 * pitch, pitch, 2 * pitch * draw.unit()});
        const double z = draw.one_of({0.0, 0.0, 0.01 * radius, -0.01 * radius, draw.between(-0.2, 0.2) * radius});
        const double x = draw.one_of({0.0, 0.0, z, draw.between(-0.01, 0.01) * radius});
        ContactQuery query = query_at({x, y, z}, reach);
        if (draw.chance(0.5)) query.point = nudged(draw, query.point);
        block.queries.push_back(query);
    }
    return block;
}

DecisionBlock make_cylinder(Draw& draw) {
    const double step = draw.one_of({0.5, 2.0, 5.0, 15.0});
    const double radius = draw.one_of({10.0, 20.0, -20.0, draw.between(5, 50)});
    const double pitch = std::abs(radius) * step * 0.0174;
    DecisionBlock block;
    block.tool = arc(4, radius, draw.one_of({-2 * step, 0.0, draw.between(-60, 60)}), step, pitch);
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.5, 1.0}));
    set_normals(block.tool);
    add_queries(draw, block, pitch, queries_per_block);
    return block;
}

DecisionBlock make_thin_sheets(Draw& draw) {
    const double thickness = draw.one_of({1e-3, 1e-6, 1e-12, 0x1p-52, draw.between(0, 0.1)});
    const bool back_to_back = draw.chance(0.5);
    const double shift = draw.one_of({0.0, 0.5, draw.unit()});
    const double wave = draw.one_of({0.0, 0.05});
    DecisionBlock block;
    DecisionTool& tool = block.tool;
    tool = sheet(2, 2, [&](int i, int j) { return Vec3(i, j, wave * i * j); });
    const DecisionTool other =
        sheet(2, 2, [&](int i, int j) { return Vec3(i + shift, j + shift, wave * i * j - thickness); });
    append(tool, back_to_back ? turned_over(other) : other);
    halve_quads(tool, draw, draw.one_of({0.0, 0.0, 0.5}));
    set_normals(tool);
    for (int i = 0; i < queries_per_block; ++i) {
        const QueryReach reach = reach_for(draw, 1);
        ContactQuery query = query_near(draw, tool, reach);
        // Between the sheets, and on each of them.
        if (draw.chance(0.5)) query.point.z() -= thickness * draw.one_of({0.5, 1.0, draw.unit()});
        block.queries.push_back(query);
    }
    return block;
}

}  // namespace type21
