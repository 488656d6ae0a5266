#include "reference/model/box.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include <fmt/format.h>

#include "reference/model/numbers.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

/// The words behind the node ids on the first line. Versions of the card keep the diameter in different columns, so it
/// is found as the last word; a whole number before it is the skew_ID.
struct Tail {
    Id skew = 0;
    bool has_diameter = false;
    std::string diameter;
};

Tail read_tail(CardReader& reader, int first, bool wants_diameter) {
    std::istringstream text(reader.text(1, first, 100));
    std::vector<std::string> words;
    for (std::string word; text >> word;)
        words.push_back(word);
    Tail tail;
    if (wants_diameter && !words.empty()) {
        tail.has_diameter = true;
        tail.diameter = words.back();
        words.pop_back();
    }
    for (const std::string& word : words) {
        Id id = 0;
        if (parse_integer(word, id) != NumberFault::none) {
            reader.error(1, "skew_ID", word, "this is not a number", "Give the ids in fields of ten columns");
        } else if (id != 0) {
            tail.skew = id;
        }
    }
    return tail;
}

double read_diameter(CardReader& reader, const Tail& tail) {
    double written = 0;
    if (tail.has_diameter && parse_real(tail.diameter, written) != NumberFault::none) {
        reader.error(1, "Diam", tail.diameter, "this is not a number", "Give the diameter, such as 25.0");
        return 0;
    }
    const double diameter = written * conversion(reader.from(), reader.to(), dim::length);
    if (!(diameter > 0)) {
        reader.error(1, "Diam", quantity(reader, diameter, dim::length), "the diameter of a box is positive",
                     "Give it behind the node ids");
    }
    return diameter;
}

Vec3 read_point(Reading& reading, CardReader& reader, Id node, size_t line, std::string_view field) {
    if (node == 0) {
        if (!reader.has_line(line)) {
            reader.error(-1, field, "", "the card ends early: this point is missing",
                         "Add the line with its X, Y and Z, 20 columns each");
        }
        return {reader.real(line, 1, 20, "X", dim::length), reader.real(line, 21, 40, "Y", dim::length),
                reader.real(line, 41, 60, "Z", dim::length)};
    }
    const Nodes& nodes = reading.model.nodes;
    const auto found = nodes.index.find(node);
    if (found != nodes.index.end()) return nodes.position[static_cast<size_t>(found->second)];
    reader.error(1, field, fmt::format("{}", node), "there is no node with this id",
                 "Add it to /NODE, or correct the id");
    return Vec3::Zero();
}

Mat3 axes_of(Reading& reading, CardReader& reader, Id skew, bool block) {
    const std::string value = fmt::format("{}", skew);
    if (!block) {
        reader.error(1, "skew_ID", value, "a cylinder or sphere has no local axes", "Leave the field blank");
    } else if (const auto other = reading.skews.refused.find(skew); other != reading.skews.refused.end()) {
        reader.error(1, "skew_ID", value, other->second, "Give the axes as a /SKEW/FIX");
    } else if (const int index = reading.reference(reader, 1, "skew_ID", skew, reading.skews, false); index >= 0) {
        return reading.model.skews[static_cast<size_t>(index)].axes;
    }
    return Mat3::Identity();
}

void check_extent(CardReader& reader, const Box& box) {
    if (box.shape == Box::Shape::cylinder && box.first == box.second) {
        reader.error(-1, "", "", "the two points of a cylinder's axis are the same",
                     "Give the ends of the axis; the cylinder ends there");
    }
}

}  // namespace

bool Box::contains(const Vec3& point) const {
    const double radius = 0.5 * diameter;
    if (shape == Shape::sphere) return (point - first).squaredNorm() <= radius * radius;
    if (shape == Shape::block) {
        const Vec3 to_point = axes.transpose() * (point - first);
        const Vec3 diagonal = axes.transpose() * (second - first);
        return (to_point.array() >= diagonal.cwiseMin(Vec3::Zero()).array()).all() &&
               (to_point.array() <= diagonal.cwiseMax(Vec3::Zero()).array()).all();
    }
    const Vec3 axis = second - first;
    const double length = axis.squaredNorm();
    const double along = axis.dot(point - first);  // times the length of the axis
    if (along < 0 || along > length) return false;
    return (point - first).cross(axis).squaredNorm() <= radius * radius * length;
}

Box read_box(Reading& reading, CardReader& reader, std::string_view type) {
    Box box;
    box.shape = type == "RECTA" ? Box::Shape::block : type == "CYLIN" ? Box::Shape::cylinder : Box::Shape::sphere;
    const bool sphere = box.shape == Box::Shape::sphere;
    const bool block = box.shape == Box::Shape::block;
    const Id node1 = reader.integer(1, 1, 10, "node_ID1");
    const Id node2 = sphere ? 0 : reader.integer(1, 11, 20, "node_ID2");
    const Tail tail = read_tail(reader, sphere ? 11 : 21, !block);
    if (tail.skew != 0) box.axes = axes_of(reading, reader, tail.skew, block);
    if (!sphere && (node1 == 0) != (node2 == 0)) {
        reader.error(1, node1 == 0 ? "node_ID1" : "node_ID2", "0", "the two points are given by two nodes or by none",
                     "Give both nodes, or neither and the coordinates");
        return box;
    }
    if (!block) box.diameter = read_diameter(reader, tail);
    box.first = read_point(reading, reader, node1, 2, node1 == 0 ? "X1" : "node_ID1");
    if (!sphere) box.second = read_point(reading, reader, node2, 3, node2 == 0 ? "X2" : "node_ID2");
    check_extent(reader, box);
    warn_of_excess(reader, sphere ? 3 : 4);
    return box;
}

}  // namespace type21
