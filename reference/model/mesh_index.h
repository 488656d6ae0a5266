/// @file Finds shells by id and by part, in time that does not grow with the mesh.
#pragma once

#include <cstddef>
#include <vector>

#include "reference/model/model.h"

namespace type21 {

/// Which shells count: those of /SHELL, those of /SH3N, or both. A /SHELL written with three nodes stays one of /SHELL.
enum class ShellKind { shell, sh3n, any };

class MeshIndex {
  public:
    /// @param first_sh3n  index of the first shell of a /SH3N card; those of /SHELL cards come before
    MeshIndex(const Model& model, int first_sh3n);

    /// Index of the shell of this kind with this id, -1 if there is none.
    int shell(ShellKind kind, Id id) const;

    /// Indices of the shells of this kind with the ids first, first + step, ... up to last.
    void append_range(ShellKind kind, Id first, Id last, Id step, std::vector<int>& shells) const;

    /// Indices of the shells of this kind in a part, ascending.
    void append_part(ShellKind kind, int part, std::vector<int>& shells) const;

    bool is(ShellKind kind, int shell) const {
        return kind == ShellKind::any || (kind == ShellKind::sh3n) == (shell >= first_sh3n_);
    }

  private:
    /// The shells of one kind in the order of their ids. Decks mostly have them so: then nothing is stored.
    struct Order {
        int begin = 0, end = 0;  ///< of the kind in Model::shells
        std::vector<int> by_id;  ///< their indices; empty when they ascend already
    };

    Order order(int begin, int end) const;
    const Order& of(ShellKind kind) const { return kind == ShellKind::sh3n ? sh3n_ : shell_; }
    int at(const Order& order, int rank) const;
    /// Rank of the first shell whose id is not below this one.
    int first_rank(const Order& order, Id id) const;
    Id id_at(const Order& order, int rank) const;

    const Model& model_;
    int first_sh3n_;
    Order shell_, sh3n_;
    std::vector<std::size_t> begin_;  ///< of each part in by_part_, and the end of the last
    std::vector<int> by_part_;        ///< shells, part by part
};

/// The same numbers ascending, each once.
/// @param size  every number is in 0..size-1
void sort_once(std::vector<int>& numbers, std::size_t size);

/// Appends the nodes of these shells; a node may come several times.
void append_nodes(const Model& model, const std::vector<int>& shells, std::vector<int>& nodes);

}  // namespace type21
