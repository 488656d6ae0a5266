/// @file Finds the index of a node by its id.
#pragma once

#include <algorithm>
#include <cstdint>
#include <stdexcept>
#include <utility>
#include <vector>

namespace type21 {

using Id = std::int64_t;

/// Pairs of id and index, sorted by id, 16 bytes each. A mesh numbers most of its nodes one after the other, so the
/// first guess is the distance from the first id; else the id is found by bisection.
class NodeIndex {
  public:
    using value_type = std::pair<Id, int>;
    using const_iterator = std::vector<value_type>::const_iterator;

    const_iterator begin() const { return pairs_.begin(); }
    const_iterator end() const { return pairs_.end(); }
    std::size_t size() const { return pairs_.size(); }
    void clear() { pairs_.clear(); }
    void reserve(std::size_t count) { pairs_.reserve(count); }

    const_iterator find(Id id) const {
        if (pairs_.empty() || id < pairs_.front().first || id > pairs_.back().first) return pairs_.end();
        const auto guess = static_cast<std::uint64_t>(id) - static_cast<std::uint64_t>(pairs_.front().first);
        if (guess < pairs_.size() && pairs_[guess].first == id)
            return pairs_.begin() + static_cast<std::ptrdiff_t>(guess);
        const auto found = lower(id);
        return found != pairs_.end() && found->first == id ? found : pairs_.end();
    }

    std::size_t count(Id id) const { return find(id) == end() ? 0 : 1; }

    /// @throws std::out_of_range when there is no such id
    int at(Id id) const {
        const auto found = find(id);
        if (found == end()) throw std::out_of_range("no node with this id");
        return found->second;
    }

    /// Adds an id, at the end where it is the largest; one that is there already stays as it is.
    void emplace(Id id, int index) {
        if (pairs_.empty() || pairs_.back().first < id) {
            pairs_.emplace_back(id, index);
        } else if (const auto place = lower(id); place->first != id) {
            pairs_.insert(place, {id, index});
        }
    }

    /// The index of an id, 0 and new where it is not there yet.
    int& operator[](Id id) {
        emplace(id, 0);
        return pairs_[static_cast<std::size_t>(find(id) - pairs_.begin())].second;
    }

  private:
    const_iterator lower(Id id) const {
        return std::lower_bound(pairs_.begin(), pairs_.end(), id,
                                [](const value_type& pair, Id wanted) { return pair.first < wanted; });
    }

    std::vector<value_type> pairs_;
};

}  // namespace type21
