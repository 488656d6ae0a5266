/// @file How decisions came about.
#pragma once

namespace type21::optimized {

/// Decisions by what settled where to look; @see Search on cores, pairs, balls.
struct PathTally {
    long certified = 0;  ///< by the core of the last sub-triangle
    long steady = 0;     ///< by a ball around where the node was searched for
    long paired = 0;     ///< between it and its neighbour over one side
    long quiet = 0;      ///< by the clearance of a node that nothing takes
    long searched = 0;   ///< by the tree
    long fine = 0;       ///< of these, settled in 100 bits
    long whole = 0;      ///< of these, settled by whole numbers

    void add(const PathTally& other) {
        certified += other.certified;
        steady += other.steady;
        paired += other.paired;
        quiet += other.quiet;
        searched += other.searched;
        fine += other.fine;
        whole += other.whole;
    }
};

}  // namespace type21::optimized
