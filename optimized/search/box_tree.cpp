#include "optimized/search/box_tree.h"

#include <algorithm>
#include <cmath>
#include <tbb/parallel_invoke.h>

namespace type21::optimized {

namespace {

constexpr std::int32_t worth_a_task = 4096;  ///< boxes; below, a task costs more than it brings

float down(double v) {
    const auto f = static_cast<float>(v);
    return double(f) > v ? std::nextafter(f, -std::numeric_limits<float>::infinity()) : f;
}
float up(double v) {
    return -down(-v);
}

}  // namespace

BoxTree::Side BoxTree::rounded_outward(const Box& box) {
    return {{down(box.low.x), down(box.low.y), down(box.low.z)}, {up(box.high.x), up(box.high.y), up(box.high.z)}};
}

BoxTree::BoxTree(const std::vector<Box>& boxes) {
    const auto count = static_cast<std::int32_t>(boxes.size());
    if (count == 0) return;
    std::vector<Leaf> order(boxes.size());
    for (std::int32_t i = 0; i < count; ++i) {
        const V3 middle = boxes[static_cast<size_t>(i)].middle();
        order[static_cast<size_t>(i)] = {
            {static_cast<float>(middle.x), static_cast<float>(middle.y), static_cast<float>(middle.z)}, i};
    }
    branch_.resize(static_cast<size_t>(std::max(1, count - 1)));
    if (count == 1) {
        branch_[0].side[0] = branch_[0].side[1] = rounded_outward(boxes[0]);
        branch_[0].below[0] = ~0;
        branch_[0].below[1] = nothing;
        return;
    }
    build(boxes, order.data(), count, 0);
}

/// The subtree of n boxes has n - 1 branches: where each lies is known before it is built, whoever builds it.
Box BoxTree::build(const std::vector<Box>& boxes, Leaf* first, std::int32_t count, std::int32_t at) {
    if (count == 1) return boxes[static_cast<size_t>(first->rank)];
    float low[3], high[3];
    for (int a = 0; a < 3; ++a)
        low[a] = high[a] = first->middle[a];
    for (std::int32_t i = 1; i < count; ++i) {
        for (int a = 0; a < 3; ++a) {
            low[a] = std::min(low[a], first[i].middle[a]);
            high[a] = std::max(high[a], first[i].middle[a]);
        }
    }
    const float spread[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
    const int axis = spread[0] >= spread[1] && spread[0] >= spread[2] ? 0 : (spread[1] >= spread[2] ? 1 : 2);
    const std::int32_t half = count / 2;
    std::nth_element(first, first + half, first + count, [axis](const Leaf& one, const Leaf& other) {
        const float a = one.middle[axis], b = other.middle[axis];
        return a < b || (a == b && one.rank < other.rank);
    });
    const std::int32_t counts[2] = {half, count - half};
    Leaf* const firsts[2] = {first, first + half};
    const std::int32_t places[2] = {at + 1, at + half};  // the first subtree has half - 1 branches
    Box below[2];
    const auto side = [&](int i) { below[i] = build(boxes, firsts[i], counts[i], places[i]); };
    if (count >= worth_a_task) {
        tbb::parallel_invoke([&] { side(0); }, [&] { side(1); });
    } else {
        side(0);
        side(1);
    }
    Branch& branch = branch_[static_cast<size_t>(at)];
    for (int i = 0; i < 2; ++i) {
        branch.side[i] = rounded_outward(below[i]);
        branch.below[i] = counts[i] == 1 ? ~firsts[i]->rank : places[i];
    }
    below[0].extend(below[1]);
    return below[0];
}

}  // namespace type21::optimized
