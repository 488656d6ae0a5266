// What the forces of a cycle share, and the way into the tool frame.
#include "optimized/kernel/force_rows.h"

namespace type21::optimized {

namespace {

template <int W>
TYPE21_INLINE void transform(Search::Batch& rows, int count, const ForceCycle& c) {
    for (int j = 0; j < count; j += W) {
        VectorLanes<Lanes<W>> x, y;
        load(rows.y[0] + j, rows.y[1] + j, rows.y[2] + j, x);
        x.x -= c.center[0];
        x.y -= c.center[1];
        x.z -= c.center[2];
        turn<true>(c.rotation, x, y);
        store(y, rows.y[0] + j, rows.y[1] + j, rows.y[2] + j);
    }
}
TYPE21_AVX512 void transform_eight(Search::Batch& rows, int count, const ForceCycle& c) {
    transform<8>(rows, count, c);
}
TYPE21_AVX2 void transform_four(Search::Batch& rows, int count, const ForceCycle& c) {
    transform<4>(rows, count, c);
}
void transform_two(Search::Batch& rows, int count, const ForceCycle& c) {
    transform<2>(rows, count, c);
}

}  // namespace

ForceCycle::ForceCycle(const Laws& of, const Cycle& cycle) : laws(&of) {
    const ToolMotion& pose = cycle.pose;
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j)
            rotation[i][j] = pose.rotation(i, j);
        center[i] = pose.position[i];
        speed[i] = pose.velocity[i];
        turning[i] = pose.angular_velocity[i];
    }
    const Interface& card = *of.card;
    viss = card.viss;
    step = cycle.motion.step;
    per_step = step > 0 ? 1 / step : 0.0;
    filtered_step = cycle.filter * cycle.motion.friction_step;
    mu = card.fric;
    limited = card.itlim == 0;
    inacti6 = cycle.inacti == 6;
}

void to_tool_frame(Search::Batch& rows, int count, const ForceCycle& cycle, SimdWidth machine) {
    compiled_for(machine, transform_eight, transform_four, transform_two)(rows, count, cycle);
}

}  // namespace type21::optimized
