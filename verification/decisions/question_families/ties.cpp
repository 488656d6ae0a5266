// Hard queries: equal candidates, and limits that are met exactly.
#include "verification/decisions/question_families/node_positions.h"
#include "verification/decisions/question_families/question_family.h"
#include "verification/decisions/question_families/tool_shapes.h"

namespace type21 {

DecisionBlock make_on_features(Draw& draw) {
    const int step = draw.one_of({0, 0, 1});
    DecisionBlock block;
    block.tool = sheet(4, 3, [&](int i, int j) { return Vec3(2 * i, 2 * j, step * (i / 2)); });
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.0, 1.0}));
    set_normals(block.tool);
    for (int i = 0; i < queries_per_block; ++i) {
        const QueryReach reach = reach_for(draw, 2);
        const double lattice = draw.one_of({0.25, 0.5, 1.0});
        const double x = lattice * draw.below(33);
        const double y = draw.chance(0.3) ? x : lattice * draw.below(25);
        const double z =
            draw.one_of({0.0, 0.0, static_cast<double>(step), 0.5 * reach.gap, reach.gap, -0.5 * reach.depth});
        block.queries.push_back(query_at({x, y, z}, reach));
    }
    return block;
}

DecisionBlock make_mesh_on_mesh(Draw& draw) {
    const double pitch = draw.one_of({0.1, 0.3, 1.7, 0.01});
    // Decimal pitches are no doubles: i * pitch and i / 10 differ in the last bit.
    const bool divided = draw.chance(0.5);
    const double origin = draw.one_of({0.0, 0.3, 12.7, -100.1});
    const auto at = [&](int i) { return divided ? origin + i * (10 * pitch) / 10 : origin + i * pitch; };
    const double level = draw.one_of({0.0, 0.3, 0.7});
    DecisionBlock block;
    block.tool = sheet(4, 4, [&](int i, int j) { return Vec3(at(i), at(j), level); });
    halve_quads(block.tool, draw, draw.one_of({0.0, 0.0, 0.0, 1.0}));
    set_normals(block.tool);
    for (int i = 0; i < queries_per_block; ++i) {
        const QueryReach reach = reach_for(draw, pitch);
        const auto place = [&] {
            const int k = draw.below(9);
            return draw.one_of({at(k / 2), origin + 0.5 * k * pitch, origin + k * pitch / 2, moved(at(k / 2), 1)});
        };
        const double x = place();
        const double y = place();
        const double z = level + draw.one_of({0.0, 0.5 * reach.gap, reach.gap, -0.5 * reach.depth, 1.5 * reach.gap});
        block.queries.push_back(query_at({x, y, z}, reach));
    }
    return block;
}

DecisionBlock make_fans(Draw& draw) {
    const int blades = 3 + draw.below(10);
    const double apex = draw.one_of({0.0, 0.25, -0.25, 1.0, draw.between(-1, 1)});
    DecisionBlock block;
    DecisionTool& tool = block.tool;
    tool.node.push_back({0, 0, apex});
    // Quads need a corner between two spokes; triangles span them.
    const bool quads = draw.chance(0.5);
    const int corners = quads ? 2 * blades : blades;
    for (int i = 0; i < corners; ++i) {
        const Turn at = turn(360.0 * i / corners);
        tool.node.push_back({at.cosine, at.sine, 0});
    }
    for (int i = 0; i < blades; ++i) {
        if (quads)
            tool.segment.push_back({0, 1 + 2 * i, 2 + 2 * i, 1 + (2 * i + 2) % corners});
        else
            tool.segment.push_back({0, 1 + i, 1 + (i + 1) % corners, 1 + (i + 1) % corners});
    }
    set_normals(tool);
    for (int i = 0; i < queries_per_block; ++i) {
        const QueryReach reach = reach_for(draw, 1);
        ContactQuery query = query_near(draw, tool, reach);
        if (draw.chance(0.6)) {
            const double h = draw.one_of({0.0, reach.gap, 0.5 * reach.gap, -0.5 * reach.depth});
            query.point = {0, 0, apex + h};
            if (draw.chance(0.4)) query.point = nudged(draw, query.point);
        }
        block.queries.push_back(query);
    }
    return block;
}

DecisionBlock make_limits_met(Draw& draw) {
    // Right triangles in the plane z = 0 with upright normals: x and y are the weights b and c times the leg, and the
    // distance is |z| or, beside the triangle, that of a 3-4-5 triangle. All of it exact.
    const double leg = draw.one_of({1.0, 2.0, 0.25});
    DecisionBlock block;
    block.tool.node = {{leg, 0, 0}, {0, leg, 0}, {0, 0, 0}};
    block.tool.normal.assign(3, Vec3::UnitZ());
    block.tool.segment = {{0, 1, 2, 2}};
    constexpr double low = -0.01;
    constexpr double high = 1.01;
    for (int i = 0; i < queries_per_block; ++i) {
        const double unit = draw.power_of_two(-10, -4) * leg;
        const QueryReach reach{5 * unit, draw.one_of({5.0, 10.0}) * unit, draw.one_of({0.0, 5.0, 10.0}) * unit};
        Vec3 p(0.25 * leg, 0.5 * leg, 0);
        switch (draw.below(6)) {
            case 0:
                p.x() = low * leg;
                break;
            case 1:
                p.y() = low * leg;
                break;
            case 2:
                p.x() = high * leg - 0.5 * leg;
                break;
            case 3:  // beside the edge b = 0: weights are clipped, and the distance is the hypotenuse
                p = {-3 * 0x1p-10 * leg, 0.5 * leg, 4 * 0x1p-10 * leg};
                break;
            default:
                p.z() = draw.one_of({reach.gap, -reach.depth, reach.proximity, 0.0});
                break;
        }
        if (p.z() == 0) p.z() = draw.one_of({0.0, unit, -unit});
        ContactQuery query = query_at(p, reach);
        if (p.x() < 0 && p.z() == 4 * 0x1p-10 * leg) {
            query.gap = 5 * 0x1p-10 * leg;
            query.proximity_reach = 0;
        }
        const int axis = draw.below(3);
        query.point[axis] = moved(query.point[axis], draw.below(3) - 1);
        if (draw.chance(0.3)) query.gap = moved(query.gap, draw.below(3) - 1);
        block.queries.push_back(query);
    }
    return block;
}

}  // namespace type21
