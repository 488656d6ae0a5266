/// @file The ContactQuery: what is asked of a contact about one node, without a scene and without history.
#pragma once

#include "vector.h"

namespace type21 {

/// One node against a tool that stands still: which sub-triangle is retained, and is it contact or proximity? The
/// answer is a Decision (decision.h). The tool itself comes separately, in the form that a reader of the query needs.
///
/// All numbers are finite and are taken as the exact values of the doubles. Nothing is checked here: the reader of a
/// file checks what it read.
/// Source: Formulation 3, steps 2 to 5 (limits and reach), and Formulation 4, step 2 (contact before proximity).
struct ContactQuery {
    Vec3 point = Vec3::Zero();         ///< P, position of the node in the tool frame [length]
    double gap = 0;                    ///< g: contact below this distance, on the outward side [length]
    double depth = 0;                  ///< DEPTH: contact below this distance, behind the surface [length]
    double proximity_reach = 0;        ///< largest reach of the active effects, outward side; 0: no proximity [length]
    double lowest_weight = -0.01;      ///< a weight b or c below it is outside; the double nearest to -0.01 [-]
    double highest_weight_sum = 1.01;  ///< b + c above it is outside; the double nearest to 1.01 [-]
    bool lift_leaning = false;         ///< D35: a corner normal with <n_V, N> <= 0 is lifted with 1e-30 instead
    bool proximity_competes = false;   ///< D11: contact and proximity compete on kappa, contact does not come first

    /// True when the last four fields have the values of the formulation, without a departure.
    bool as_documented() const {
        const ContactQuery documented;
        return lowest_weight == documented.lowest_weight && highest_weight_sum == documented.highest_weight_sum &&
               !lift_leaning && !proximity_competes;
    }
};

}  // namespace type21
