/// @file The Decision: which sub-triangle of the tool a node touches, and how.
#pragma once

namespace type21 {

/// What the retained sub-triangle is to the node.  Formulation 3, step 5.
enum class Kind { none, contact, proximity };

/// The arithmetic that settled a decision: each is asked only where the one before it cannot tell.
/// Formulation 10, step 6.
enum class Stage {
    bounded,   ///< double with a bound on its error
    interval,  ///< interval of doubles, rounded outwards
    exact      ///< rational numbers
};

/// The single retained impact of a node. It depends on the state of the cycle only, not on earlier cycles.
/// Formulation 4, step 5.
struct Decision {
    Kind kind = Kind::none;
    int segment = -1;  ///< rank in the main surface, from 0
    int triangle = 0;  ///< sub-triangle k, 1..4
    int side = 0;      ///< +1 outward of the sub-triangle's plane (or on it), -1 behind
    double b = 0;      ///< weight of B, unclipped [-]
    double c = 0;      ///< weight of C, unclipped [-]
    Stage stage = Stage::bounded;
};

}  // namespace type21
