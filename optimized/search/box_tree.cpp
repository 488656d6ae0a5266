#include "optimized/search/box_tree.h"

#include <cmath>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

namespace type21::optimized {

namespace {

constexpr std::int32_t worth_tasks = 4096;  ///< boxes; with fewer, a task costs more than it saves

/// The largest float <= v, or the one below it. Without a branch, which would be predicted wrongly half of the time.
/// The float below has the neighbouring pattern of bits.
TYPE21_INLINE float down(double v) {
    const auto f = static_cast<float>(v);
    const auto bits = std::bit_cast<std::int32_t>(f);
    const std::int32_t below = 1 | ~(bits >> 31);  // -1 where f > 0, +1 where f < 0
    return std::bit_cast<float>(bits + (double(f) > v ? below : 0));
}
TYPE21_INLINE float up(double v) {
    return -down(-v);
}

/// Number of boxes of each subtree of a branch except the last: a multiple of a branch of leaves.
std::int32_t share_of(std::int32_t count) {
    constexpr std::int32_t wide = BoxTree::wide;
    if (count <= wide) return 1;
    const std::int32_t share = (count + wide - 1) / wide;
    return (share + wide - 1) / wide * wide;
}

std::int32_t branches_of(std::int32_t count) {
    if (count <= BoxTree::wide) return 1;
    const std::int32_t share = share_of(count), full = (count - 1) / share;
    return 1 + full * branches_of(share) + branches_of(count - full * share);
}

template <int W>
struct FloatsOf {
    typedef float Real __attribute__((vector_size(W * sizeof(float))));
};

#if defined(__x86_64__)
TYPE21_AVX2 unsigned bits_of(const FloatsOf<8>::Real& mask) {
    return static_cast<unsigned>(__builtin_ia32_movmskps256(mask));
}
TYPE21_INLINE unsigned bits_of(const FloatsOf<4>::Real& mask) {
    return static_cast<unsigned>(__builtin_ia32_movmskps(mask));
}
#else
template <class V>
unsigned bits_of(const V& mask) {
    unsigned bits = 0;
    int lane[sizeof(V) / sizeof(int)];
    __builtin_memcpy(lane, &mask, sizeof(V));
    for (size_t i = 0; i < sizeof(V) / sizeof(int); ++i)
        bits |= static_cast<unsigned>(lane[i] < 0) << i;
    return bits;
}
#endif

/// The boxes from `at` on.
template <int W, class Branch, class Query>
TYPE21_INLINE unsigned test_some(const Branch& branch, int at, const Query& query, float* distance2) {
    using V = typename FloatsOf<W>::Real;
    V sum{};
    for (int a = 0; a < 3; ++a) {
        V low, high;
        __builtin_memcpy(&low, branch.low[a] + at, sizeof(V));
        __builtin_memcpy(&high, branch.high[a] + at, sizeof(V));
        V d = low - query.high[a];
        const V other = query.low[a] - high, zero{};
        d = d > other ? d : other;
        d = d > zero ? d : zero;
        sum += d * d;
    }
    __builtin_memcpy(distance2 + at, &sum, sizeof(V));
    return bits_of((V)(sum <= query.most)) << at;
}

}  // namespace

TYPE21_AVX2 unsigned BoxTree::test_eight(const Branch& branch, const Query& query, float* distance2) {
    return test_some<8>(branch, 0, query, distance2);
}

unsigned BoxTree::test_four(const Branch& branch, const Query& query, float* distance2) {
    return test_some<4>(branch, 0, query, distance2) | test_some<4>(branch, 4, query, distance2);
}

BoxTree::Query BoxTree::query_of(const Box& box, double distance) {
    Query query{};
    for (int a = 0; a < 3; ++a) {
        query.low[a] = down(box.low[a]);
        query.high[a] = up(box.high[a]);
    }
    limit(query, distance);
    return query;
}

/// From 1e15 on squares overflow, and everything counts as near.
void BoxTree::limit(Query& query, double distance) {
    query.most =
        distance < 1e15 ? up(distance * distance * (1 + 1e-5) + double(tiny)) : std::numeric_limits<float>::infinity();
}

BoxTree::BoxTree(const std::vector<Box>& boxes, SimdWidth machine)
    : test_(machine == SimdWidth::two ? test_four : test_eight) {
    const auto count = static_cast<std::int32_t>(boxes.size());
    if (count == 0) return;
    std::vector<Leaf> order(boxes.size());
    for (std::int32_t i = 0; i < count; ++i) {
        const V3 middle = boxes[static_cast<size_t>(i)].middle();
        order[static_cast<size_t>(i)] = {
            {static_cast<float>(middle.x), static_cast<float>(middle.y), static_cast<float>(middle.z)}, i};
    }
    branch_.resize(static_cast<size_t>(branches_of(count)));
    build(boxes, order.data(), count, 0);
}

/// The number of branches of a subtree depends on the number of its boxes only. So the place of each branch is known
/// before it is built, whichever thread builds it.
Box BoxTree::build(const std::vector<Box>& boxes, Leaf* first, std::int32_t count, std::int32_t at) {
    const std::int32_t share = share_of(count), parts = (count + share - 1) / share;
    // Halves along the longest axis, until each part is single.
    const auto divide = [&](const auto& self, std::int32_t from, std::int32_t to) -> void {
        if (to - from < 2) return;
        Leaf *const begin = first + from * share, *const end = first + std::min(to * share, count);
        float low[3], high[3];
        for (int a = 0; a < 3; ++a)
            low[a] = high[a] = begin->middle[a];
        for (const Leaf* leaf = begin; leaf != end; ++leaf) {
            for (int a = 0; a < 3; ++a) {
                low[a] = std::min(low[a], leaf->middle[a]);
                high[a] = std::max(high[a], leaf->middle[a]);
            }
        }
        const float spread[3] = {high[0] - low[0], high[1] - low[1], high[2] - low[2]};
        const int axis = spread[0] >= spread[1] && spread[0] >= spread[2] ? 0 : (spread[1] >= spread[2] ? 1 : 2);
        const std::int32_t middle = (from + to) / 2;
        std::nth_element(begin, first + middle * share, end, [axis](const Leaf& one, const Leaf& other) {
            const float a = one.middle[axis], b = other.middle[axis];
            return a < b || (a == b && one.rank < other.rank);
        });
        const auto half = [&](bool second) { return second ? self(self, middle, to) : self(self, from, middle); };
        if (end - begin >= worth_tasks) {
            tbb::parallel_invoke([&] { half(false); }, [&] { half(true); });
        } else {
            half(false);
            half(true);
        }
    };
    divide(divide, 0, parts);
    Box below[wide], all;
    const auto part = [&](std::int32_t i) {
        Leaf* const begin = first + i * share;
        below[i] = share == 1
                       ? boxes[static_cast<size_t>(begin->rank)]
                       : build(boxes, begin, std::min(share, count - i * share), at + 1 + i * branches_of(share));
    };
    if (count >= worth_tasks) {
        tbb::parallel_for(0, parts, part);
    } else {
        for (std::int32_t i = 0; i < parts; ++i)
            part(i);
    }
    Branch& branch = branch_[static_cast<size_t>(at)];
    for (std::int32_t i = 0; i < wide; ++i) {
        if (i < parts) all.extend(below[i]);
        for (int a = 0; a < 3; ++a) {
            // An empty place is infinitely far from all that is finite.
            branch.low[a][i] = i < parts ? down(below[i].low[a]) : std::numeric_limits<float>::infinity();
            branch.high[a][i] = i < parts ? up(below[i].high[a]) : -std::numeric_limits<float>::infinity();
        }
        branch.below[i] = i >= parts ? nothing : (share == 1 ? ~first[i].rank : at + 1 + i * branches_of(share));
    }
    return all;
}

}  // namespace type21::optimized
