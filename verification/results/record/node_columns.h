/// @file The columns of nodes.csv: the variables of /TH/NODE.
#pragma once

#include <string>
#include <vector>

#include "reference/host/march.h"

namespace type21 {

struct NodeColumn {
    std::string name;
    double (*value)(const CycleRecord&, size_t node);
};

/// Every variable in the order of the file: DX DY DZ VX .. AX .. VRX .. REACX .. REACXX .. X Y Z.
const std::vector<NodeColumn>& node_columns();

/// The nodes and variables of all /TH/NODE groups of a deck.
struct NodeHistory {
    std::vector<int> nodes;           ///< index into Model::nodes, ascending, each once
    std::vector<NodeColumn> columns;  ///< union over the groups
};

NodeHistory node_history(const Model& model);

}  // namespace type21
