/// @file Counts of how decisions were reached.
#pragma once

namespace type21::optimized {

/// Decisions by certificate; @see Path.
struct PathTally {
    long exclusive_region = 0;  ///< in the exclusive region of the last sub-triangle, or above a corner where it leads
    long ranking_safe = 0;      ///< within the ranking safe radius
    long edge_neighbour = 0;    ///< between the last sub-triangle and its neighbour over one side
    long separated = 0;         ///< within the separated radius: nothing takes the node
    long searched = 0;          ///< by a full search
    long double_double = 0;     ///< of these, settled in double-double
    long integer = 0;           ///< of these, settled in integers
    // Of the sorted search only.
    long candidates = 0;  ///< segments in the lists of the nodes that were searched for
    long near = 0;        ///< of these, segments whose boxes held the node

    void add(const PathTally& other) {
        exclusive_region += other.exclusive_region;
        ranking_safe += other.ranking_safe;
        edge_neighbour += other.edge_neighbour;
        separated += other.separated;
        searched += other.searched;
        double_double += other.double_double;
        integer += other.integer;
        candidates += other.candidates;
        near += other.near;
    }

    template <class Archive>
    void visit_state(Archive& archive) {
        auto& [region, ranking, neighbour, apart, by_search, by_double_double, by_integer, listed, holding] = *this;
        archive(region, ranking, neighbour, apart, by_search, by_double_double, by_integer, listed, holding);
    }
};

}  // namespace type21::optimized
