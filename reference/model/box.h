/// @file /BOX/RECTA, /BOX/CYLIN and /BOX/SPHER: a piece of space.
#pragma once

#include "reference/contract/vector.h"
#include "reference/model/card_reader.h"

namespace type21 {

struct Reading;

/// Its border belongs to it.
struct Box {
    enum class Shape { block, cylinder, sphere };
    Shape shape = Shape::block;
    Vec3 first = Vec3::Zero();   ///< a corner of the block, an end of the cylinder's axis, the centre of the sphere
    Vec3 second = Vec3::Zero();  ///< the opposite corner, the other end
    double diameter = 0;
    Mat3 axes = Mat3::Identity();  ///< of the block: columns are the directions of its edges

    bool contains(const Vec3& point) const;
};

/// Reads the card: a line with up to two node ids, the skew_ID and the diameter, then one or two points. A node stands
/// for a point where its id is given, with its position at time 0. The points are in global axes; with a skew_ID the
/// edges of a block run along the axes of that /SKEW/FIX.
/// @param type  "RECTA", "CYLIN" or "SPHER"
Box read_box(Reading& reading, CardReader& reader, std::string_view type);

}  // namespace type21
