// The nodes are halved along the longest axis of their box, again and again. Each half takes along the segments whose
// grown boxes meet its own box. So both are sorted at once, and a segment far from all nodes is looked at once.
#include "optimized/search/sorted/candidate_lists.h"

#include <algorithm>
#include <numeric>
#include <tbb/parallel_invoke.h>
#include <unordered_set>

namespace type21::optimized {

namespace {

constexpr size_t worth_tasks = 4096;  ///< nodes; with fewer, a task costs more than it saves
constexpr size_t long_list = 32;      ///< segments; shorter lists are not worth sharing

bool meet(const Box& segment, double reach, const Box& nodes) {
    return segment.low.x - reach <= nodes.high.x && nodes.low.x <= segment.high.x + reach &&
           segment.low.y - reach <= nodes.high.y && nodes.low.y <= segment.high.y + reach &&
           segment.low.z - reach <= nodes.high.z && nodes.low.z <= segment.high.z + reach;
}

int longest_axis(const Box& box) {
    const V3 size = box.high - box.low;
    return size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
}

}  // namespace

CandidateLists::CandidateLists(const std::vector<Box>& boxes, double margin) : boxes_(boxes), margin_(margin) {
    for (const Box& box : boxes)
        whole_.extend(box);
    // y - y0 and the sides of the grown boxes are rounded: relatively by 2^-53 of the margin and of the coordinates.
    const double farthest = boxes.empty() ? 0 : std::max(largest(whole_.low), largest(whole_.high));
    reach_ = margin * (1 + 1e-12) + 0x1p-51 * farthest;
    Ranks ranks(boxes.size());
    std::iota(ranks.begin(), ranks.end(), 0);
    all_ = std::make_shared<const Ranks>(std::move(ranks));
}

void CandidateLists::sort(std::vector<V3> y) {
    ++sorts_;
    at_ = std::move(y);
    list_.assign(at_.size(), {});
    // Nodes beside all segments have no candidates.
    std::vector<int> near;
    for (size_t i = 0; i < at_.size(); ++i)
        if (meet(whole_, reach_, {at_[i], at_[i]})) near.push_back(static_cast<int>(i));
    groups_.clear();
    groups_.resize((near.size() + group_size - 1) / group_size);
    if (!near.empty()) halve(near, 0, all_);
    bytes_ = count_bytes();
}

/// @param first  rank of the first of these nodes in the order that halving makes, a multiple of group_size
void CandidateLists::halve(std::span<int> nodes, size_t first, const SharedRanks& candidates) {
    Box box;
    for (const int i : nodes)
        box.extend(at_[static_cast<size_t>(i)]);
    Ranks found;
    for (const int s : *candidates)
        if (meet(boxes_[static_cast<size_t>(s)], reach_, box)) found.push_back(s);
    if (found.empty()) return;
    // A list that hardly became shorter is not worth a copy. So memory stays small where the margin is large, or where
    // DEPTH puts everything into everything's reach.
    const bool shares = 4 * found.size() > 3 * candidates->size();
    const SharedRanks own = shares ? candidates : std::make_shared<const Ranks>(std::move(found));
    if (nodes.size() <= group_size) return list_group(nodes, groups_[first / group_size], own);
    const size_t half = (nodes.size() / 2 + group_size - 1) / group_size * group_size;
    const int axis = longest_axis(box);
    std::nth_element(nodes.begin(), nodes.begin() + static_cast<std::ptrdiff_t>(half), nodes.end(), [&](int i, int j) {
        const double one = at_[static_cast<size_t>(i)][axis], other = at_[static_cast<size_t>(j)][axis];
        return one < other || (one == other && i < j);
    });
    const auto lower = [&] { halve(nodes.first(half), first, own); };
    const auto upper = [&] { halve(nodes.subspan(half), first + half, own); };
    if (nodes.size() >= worth_tasks) {
        tbb::parallel_invoke(lower, upper);
    } else {
        lower();
        upper();
    }
}

void CandidateLists::list_group(std::span<const int> nodes, Group& group, const SharedRanks& candidates) {
    size_t end[group_size];
    bool shares[group_size];
    for (size_t j = 0; j < nodes.size(); ++j) {
        const V3& y = at_[static_cast<size_t>(nodes[j])];
        const size_t start = group.own.size();
        for (const int s : *candidates)
            if (meet(boxes_[static_cast<size_t>(s)], reach_, {y, y})) group.own.push_back(s);
        shares[j] = candidates->size() > long_list && 2 * (group.own.size() - start) > candidates->size();
        if (shares[j]) {
            group.own.resize(start);
            group.shared = candidates;
        }
        end[j] = group.own.size();
    }
    group.own.shrink_to_fit();
    const std::span<const int> all(group.own);
    for (size_t j = 0, start = 0; j < nodes.size(); start = end[j++])
        list_[static_cast<size_t>(nodes[j])] = shares[j] ? *group.shared : all.subspan(start, end[j] - start);
}

size_t CandidateLists::count_bytes() const {
    size_t bytes = at_.capacity() * sizeof(V3) + list_.capacity() * sizeof(list_[0]) +
                   groups_.capacity() * sizeof(Group) + all_->capacity() * sizeof(int);
    std::unordered_set<const Ranks*> counted{all_.get()};
    for (const Group& group : groups_) {
        bytes += group.own.capacity() * sizeof(int);
        if (group.shared && counted.insert(group.shared.get()).second) bytes += group.shared->capacity() * sizeof(int);
    }
    return bytes;
}

}  // namespace type21::optimized
