/// @file Decisions without a deck: a small tool, queries about nodes near it, and the answers. The content of a
/// decision file (decision_json.h).
#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "reference/contract/contact_query.h"
#include "reference/contract/decision.h"
#include "reference/contract/vector.h"

namespace type21 {

/// A tool in its own frame. The nodal normals are used as given, also where they are not of unit length.
struct DecisionTool {
    std::vector<Vec3> node;                   ///< [length]
    std::vector<Vec3> normal;                 ///< one for each node [-]
    std::vector<std::array<int, 4>> segment;  ///< indices into node, from 0; a triangle repeats its third node
};

/// The retained impact of one query.
struct DecisionAnswer {
    Kind kind = Kind::none;
    int segment = -1;              ///< index into DecisionTool::segment; -1: none
    int triangle = 0;              ///< sub-triangle k, 1..4; 0: none
    int side = 0;                  ///< +1 outward, -1 behind; 0: none
    Stage stage = Stage::bounded;  ///< the last that was needed
    double margin = 0;             ///< how far the node may move before another answer, to first order [length]
    double margin_ulps = 0;        ///< the same in units of the last place of the node's largest coordinate [-]

    bool same_decision(const DecisionAnswer& other) const {
        return kind == other.kind && segment == other.segment && triangle == other.triangle && side == other.side;
    }
};

/// One tool and its queries.
struct DecisionBlock {
    DecisionTool tool;
    std::vector<ContactQuery> queries;
    std::vector<DecisionAnswer> answers;  ///< one for each query, or none
};

struct DecisionFile {
    std::string family;  ///< name of the question family that the queries were drawn from; may be empty
    std::string with;    ///< the method under test that the fuzzer writes down; may be empty
    std::vector<DecisionBlock> blocks;
};

std::string_view name(Kind kind);    ///< "contact", "proximity", "none"
std::string_view name(Stage stage);  ///< "double", "interval", "exact"

}  // namespace type21
