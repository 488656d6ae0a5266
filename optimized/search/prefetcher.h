/// @file Prefetching of the arrays of the nodes.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "optimized/simd/simd_width.h"

namespace type21::optimized {

/// Arrays with some bytes for each node. A cache line takes as long to arrive as the work on several nodes, and only a
/// few can be under way at once. So while eight nodes are worked on, those of eight others are prefetched, a batch
/// ahead. No number changes. Always inlined: a compiler takes a function of prefetches only for one that does nothing.
class Prefetcher {
  public:
    static constexpr int group = 8, distance = 256;  ///< distance is the capacity of a batch

    /// @param last  one past the last node
    explicit Prefetcher(int last) : last_(last) {}
    template <class Number>
    void add(const std::vector<Number>& of) {
        if (!of.empty()) add(of.data(), sizeof(Number));
    }
    void add(const void* first, size_t bytes) { array_[arrays_++] = {static_cast<const char*>(first), bytes}; }
    /// Vectors that are stored by index; consecutive nodes mostly have consecutive indices.
    template <class Vector>
    void add(std::span<const Vector> of, const std::vector<int>& index) {
        index_ = index.data();
        indexed_[indexed_arrays_++] = {reinterpret_cast<const char*>(of.data()), sizeof(Vector)};
    }
    /// To be called when eight nodes from this one on are worked on.
    TYPE21_INLINE void prefetch(int node) const {
        const int next = node + distance;
        if (next >= last_) return;
        for (size_t i = 0; i < arrays_; ++i)
            prefetch(array_[i], next);
        for (size_t i = 0; i < indexed_arrays_; ++i)
            prefetch(indexed_[i], index_[next]);
    }

  private:
    struct Array {
        const char* first;
        size_t bytes;
    };
    static TYPE21_INLINE void prefetch(const Array& array, int at) {
        const char* const from = array.first + static_cast<size_t>(at) * array.bytes;
        for (size_t b = 0; b < group * array.bytes; b += 64)
            __builtin_prefetch(from + b);
    }

    int last_;
    std::array<Array, 12> array_;
    std::array<Array, 2> indexed_;
    const int* index_ = nullptr;
    size_t arrays_ = 0, indexed_arrays_ = 0;
};

}  // namespace type21::optimized
