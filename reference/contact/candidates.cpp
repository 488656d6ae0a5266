#include "reference/contact/candidates.h"

#include <algorithm>
#include <numeric>

namespace type21::reference {

namespace {
constexpr int leaf_size = 4;
constexpr double rounding = 1e-9;
}  // namespace

Candidates::Candidates(const ToolSurface& tool, double reach) {
    const double margin = reach + rounding * (reach + tool.farthest().norm());
    boxes_.reserve(static_cast<size_t>(tool.size()));
    for (int s = 0; s < tool.size(); ++s) {
        const SegmentShape<double> shape = tool.shape(s);
        Box box;
        for (const Vec3& y : shape.node)
            box.extend(y);
        box.min().array() -= margin;
        box.max().array() += margin;
        boxes_.push_back(box);
    }
    order_.resize(boxes_.size());
    std::iota(order_.begin(), order_.end(), 0);
    if (boxes_.empty()) return;
    branches_.emplace_back();
    build(0, 0, tool.size());
}

void Candidates::build(int branch, int first, int count) {
    const auto begin = order_.begin() + first;
    Box box;
    Box centers;
    for (auto it = begin; it != begin + count; ++it) {
        box.extend(boxes_[static_cast<size_t>(*it)]);
        centers.extend(boxes_[static_cast<size_t>(*it)].center());
    }
    branches_[static_cast<size_t>(branch)].box = box;
    if (count <= leaf_size) {
        branches_[static_cast<size_t>(branch)].first = first;
        branches_[static_cast<size_t>(branch)].count = count;
        return;
    }
    Eigen::Index axis = 0;
    centers.sizes().maxCoeff(&axis);
    const int half = count / 2;
    std::nth_element(begin, begin + half, begin + count, [&](int left, int right) {
        return boxes_[static_cast<size_t>(left)].center()[axis] < boxes_[static_cast<size_t>(right)].center()[axis];
    });
    const int below = static_cast<int>(branches_.size());
    branches_[static_cast<size_t>(branch)].below = below;
    branches_.resize(branches_.size() + 2);
    build(below, first, half);
    build(below + 1, first + half, count - half);
}

std::vector<int> Candidates::at(const Vec3& y) const {
    std::vector<int> found;
    if (branches_.empty()) return found;
    std::vector<int> open{0};
    while (!open.empty()) {
        const Branch& branch = branches_[static_cast<size_t>(open.back())];
        open.pop_back();
        if (!branch.box.contains(y)) continue;
        if (branch.count == 0) {
            open.push_back(branch.below);
            open.push_back(branch.below + 1);
            continue;
        }
        for (int i = 0; i < branch.count; ++i) {
            const int segment = order_[static_cast<size_t>(branch.first) + static_cast<size_t>(i)];
            if (boxes_[static_cast<size_t>(segment)].contains(y)) found.push_back(segment);
        }
    }
    std::sort(found.begin(), found.end());
    return found;
}

}  // namespace type21::reference
