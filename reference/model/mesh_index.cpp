#include "reference/model/mesh_index.h"

#include <algorithm>
#include <numeric>

namespace type21 {

MeshIndex::MeshIndex(const Model& model, int first_sh3n)
    : model_(model), first_sh3n_(first_sh3n), begin_(model.parts.size() + 1, 0) {
    const int count = static_cast<int>(model.shells.size());
    shell_ = order(0, first_sh3n);
    sh3n_ = order(first_sh3n, count);
    for (const Shell& shell : model.shells)
        ++begin_[static_cast<std::size_t>(shell.part) + 1];
    for (std::size_t part = 1; part < begin_.size(); ++part)
        begin_[part] += begin_[part - 1];
    by_part_.resize(model.shells.size());
    std::vector<std::size_t> next = begin_;
    for (int i = 0; i < count; ++i)
        by_part_[next[static_cast<std::size_t>(model.shells[static_cast<std::size_t>(i)].part)]++] = i;
}

MeshIndex::Order MeshIndex::order(int begin, int end) const {
    Order order{begin, end, {}};
    const auto& shells = model_.shells;
    const auto by_id = [](const Shell& a, const Shell& b) { return a.id < b.id; };
    if (std::is_sorted(shells.begin() + begin, shells.begin() + end, by_id)) return order;
    order.by_id.resize(static_cast<std::size_t>(end - begin));
    std::iota(order.by_id.begin(), order.by_id.end(), begin);
    std::sort(order.by_id.begin(), order.by_id.end(), [&](int a, int b) {
        return shells[static_cast<std::size_t>(a)].id < shells[static_cast<std::size_t>(b)].id;
    });
    return order;
}

int MeshIndex::at(const Order& order, int rank) const {
    return order.by_id.empty() ? order.begin + rank : order.by_id[static_cast<std::size_t>(rank)];
}

Id MeshIndex::id_at(const Order& order, int rank) const {
    return model_.shells[static_cast<std::size_t>(at(order, rank))].id;
}

int MeshIndex::first_rank(const Order& order, Id id) const {
    int low = 0;
    int high = order.end - order.begin;
    while (low < high) {
        const int middle = low + (high - low) / 2;
        if (id_at(order, middle) < id) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

int MeshIndex::shell(ShellKind kind, Id id) const {
    const Order& order = of(kind);
    const int rank = first_rank(order, id);
    return rank < order.end - order.begin && id_at(order, rank) == id ? at(order, rank) : -1;
}

void MeshIndex::append_range(ShellKind kind, Id first, Id last, Id step, std::vector<int>& shells) const {
    const Order& order = of(kind);
    for (int rank = first_rank(order, first); rank < order.end - order.begin; ++rank) {
        const Id id = id_at(order, rank);
        if (id > last) break;
        if ((id - first) % step == 0) shells.push_back(at(order, rank));
    }
}

void MeshIndex::append_part(ShellKind kind, int part, std::vector<int>& shells) const {
    const auto at = static_cast<std::size_t>(part);
    for (std::size_t i = begin_[at]; i < begin_[at + 1]; ++i) {
        if (is(kind, by_part_[i])) shells.push_back(by_part_[i]);
    }
}

void sort_once(std::vector<int>& numbers, std::size_t size) {
    if (numbers.size() > size / 8) {
        // A mark for each is quicker than sorting a large share of all.
        std::vector<char> chosen(size, 0);
        for (const int number : numbers)
            chosen[static_cast<std::size_t>(number)] = 1;
        numbers.clear();
        for (std::size_t i = 0; i < size; ++i) {
            if (chosen[i] != 0) numbers.push_back(static_cast<int>(i));
        }
        return;
    }
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
}

void append_nodes(const Model& model, const std::vector<int>& shells, std::vector<int>& nodes) {
    for (const int index : shells) {
        const Shell& shell = model.shells[static_cast<std::size_t>(index)];
        nodes.insert(nodes.end(), shell.node.begin(), shell.node.begin() + shell.corners());
    }
}

}  // namespace type21
