/// @file A question to the contact without a deck: a small tool, a node, its limits; and the answer.
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "reference/contract/decision.h"
#include "reference/contract/vector.h"

namespace type21 {

/// A tool in its own frame; the nodal normals are taken as they are given.
struct DecisionTool {
    std::vector<Vec3> node;                   ///< [length]
    std::vector<Vec3> normal;                 ///< one for each node [-]
    std::vector<std::array<int, 4>> segment;  ///< ranks of nodes from 0; a triangle repeats its third node
};

struct DecisionQuery {
    Vec3 point = Vec3::Zero();  ///< secondary node in the tool frame [length]
    double gap = 0;             ///< g [length]
    double depth = 0;           ///< DEPTH [length]
    double reach = 0;           ///< of proximity, 0 without [length]
};

struct DecisionAnswer {
    Kind kind = Kind::none;
    int segment = -1;  ///< -1: none
    int triangle = 0;  ///< 1..4
    int side = 0;      ///< +1, -1
    Stage stage = Stage::bounded;
    double margin = 0;       ///< how far the node may move before another answer, to first order [length]
    double margin_ulps = 0;  ///< the same in units of the last place of the node's largest coordinate

    bool same_decision(const DecisionAnswer& other) const {
        return kind == other.kind && segment == other.segment && triangle == other.triangle && side == other.side;
    }
};

struct DecisionBlock {
    DecisionTool tool;
    std::vector<DecisionQuery> queries;
    std::vector<DecisionAnswer> answers;  ///< one for each query, or none
};

struct DecisionFile {
    std::string family;
    std::vector<DecisionBlock> blocks;
};

std::string_view name(Kind kind);    ///< "contact", "proximity", "none"
std::string_view name(Stage stage);  ///< "double", "interval", "exact"

}  // namespace type21
