/// @file Which search finds the segments that may take a node.
#pragma once

namespace type21::optimized {

/// Both lead to the same decisions: the same exact code judges what they find, and each finds all that can count.
enum class SearchKind {
    tree,   ///< a tree of boxes, asked where no certificate holds (README.md of optimized/)
    sorted  ///< lists of candidates that are kept until a node has moved too far, as the field Bumult means it
            ///< (sorted/)
};

}  // namespace type21::optimized
