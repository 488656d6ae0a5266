/// @file IBC: the flagged translations of a boundary condition are released, for good, at the first effective
/// penetration (Formulation 9, step 13).
#pragma once

#include <vector>

namespace type21::reference {

/// Which nodes have been released. Present only when the card asks for IBC.
/// @manual field IBC; comment 7
class Release {
  public:
    explicit Release(int nodes) : released_(static_cast<size_t>(nodes), 0) {}

    /// True once for each node, at its first effective penetration.
    /// @param i            rank in SecondarySide::node, not checked
    /// @param penetration  p [length]
    bool now(int i, double penetration) {
        char& released = released_[static_cast<size_t>(i)];
        if (penetration <= 0 || released != 0) return false;
        released = 1;
        return true;
    }
    /// What a checkpoint holds; @see StateWriter
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(released_);
    }

    static constexpr size_t bytes_per_node() { return sizeof(char); }

  private:
    std::vector<char> released_;
};

}  // namespace type21::reference
