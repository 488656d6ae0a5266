#include <numbers>
#include <optional>
#include <string>
#include <unordered_set>
#include <vector>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "reference/model/selector.h"

namespace type21 {

namespace {

/// x becomes linear * x + shift.
struct Affine {
    Mat3 linear = Mat3::Identity();
    Vec3 shift = Vec3::Zero();

    static Affine about(const Vec3& point, const Mat3& linear) { return {linear, point - linear * point}; }
};

Vec3 vector_of(CardReader& reader, size_t line, std::string_view name, Dimension dimension) {
    const auto part = [&](int first, char axis) {
        return reader.real(line, first, first + 19, fmt::format("{}{}", axis, name), dimension);
    };
    return {part(11, 'X'), part(31, 'Y'), part(51, 'Z')};
}

/// Where a node stands that a field of line 1 names, after the transformations before this one; none for 0.
std::optional<Vec3> node_at(Reading& reading, CardReader& reader, int first, std::string_view field) {
    const Id id = reader.integer(1, first, first + 9, field);
    if (id == 0) return std::nullopt;
    const Nodes& nodes = reading.model.nodes;
    const auto found = nodes.index.find(id);
    if (found != nodes.index.end()) return nodes.position[static_cast<size_t>(found->second)];
    reader.error(1, field, fmt::format("{}", id), "there is no node with this id",
                 "Add it to /NODE, or correct the id");
    return Vec3::Zero();
}

struct Points {
    Vec3 first, second;
};

/// Two points, each by its node or by its coordinates in lines 1 and 2.
Points points_of(Reading& reading, CardReader& reader) {
    Points points{vector_of(reader, 1, "_point_1", dim::length), vector_of(reader, 2, "_point_2", dim::length)};
    if (const auto node = node_at(reading, reader, 71, "node_ID1")) points.first = *node;
    if (const auto node = node_at(reading, reader, 81, "node_ID2")) points.second = *node;
    return points;
}

Vec3 axis_of(CardReader& reader, const Points& points) {
    const Vec3 axis = points.second - points.first;
    if (axis.norm() > 0) return axis.normalized();
    reader.error(-1, "", "", "the two points of a /TRANSFORM are the same, so that they give no direction",
                 "Give two different points, or two different nodes");
    return Vec3::UnitX();
}

Affine translation(Reading& reading, CardReader& reader) {
    const Vec3 given = vector_of(reader, 1, "_translation", dim::length);
    const auto from = node_at(reading, reader, 71, "node_ID1");
    const auto to = node_at(reading, reader, 81, "node_ID2");
    if (from.has_value() != to.has_value()) {
        reader.error(1, from ? "node_ID2" : "node_ID1", "0", "a translation is given by two nodes or by none",
                     "Give both nodes, or neither and the components");
    }
    warn_of_excess(reader, 2);
    return {Mat3::Identity(), from && to ? Vec3(*to - *from) : given};
}

/// Angle in degrees; it turns by the right-hand rule about the axis from point 1 to point 2.
Affine rotation(Reading& reading, CardReader& reader) {
    const Points points = points_of(reading, reader);
    const double angle = reader.real(2, 71, 90, "Angle", dim::none) * std::numbers::pi / 180;
    warn_of_excess(reader, 3);
    return Affine::about(points.first, Eigen::AngleAxisd(angle, axis_of(reader, points)).toRotationMatrix());
}

/// The mirror is the plane through point 1 at right angles to the line to point 2.
Affine symmetry(Reading& reading, CardReader& reader) {
    const Points points = points_of(reading, reader);
    const Vec3 normal = axis_of(reader, points);
    warn_of_excess(reader, 3);
    return Affine::about(points.first, Mat3::Identity() - 2 * normal * normal.transpose());
}

/// About a node or the origin. A factor of 0 or blank is 1.
Affine scaling(Reading& reading, CardReader& reader) {
    Vec3 factors = vector_of(reader, 1, "_scale", dim::none);
    for (int axis = 0; axis < 3; ++axis)
        factors[axis] = factors[axis] == 0 ? 1 : factors[axis];
    const Vec3 center = node_at(reading, reader, 71, "node_ID1").value_or(Vec3::Zero());
    warn_of_excess(reader, 2);
    return Affine::about(center, factors.asDiagonal().toDenseMatrix());
}

/// Three rows of the matrix and the shift, 20 columns each.
Affine matrix(CardReader& reader) {
    Affine map;
    for (int row = 0; row < 3; ++row) {
        const size_t line = 2 + static_cast<size_t>(row);
        for (int column = 0; column < 3; ++column) {
            const int first = 1 + 20 * column;
            map.linear(row, column) =
                reader.real(line, first, first + 19, fmt::format("M{}{}", row + 1, column + 1), dim::none);
        }
        map.shift[row] = reader.real(line, 61, 80, fmt::format("V{}", row + 1), dim::length);
    }
    if (!reader.has_line(4)) {
        reader.error(-1, "", "", "the card ends early: a matrix has three lines behind that of grnod_ID",
                     "Give M11 M12 M13 V1, and so on, 20 columns each");
    } else if (map.linear.determinant() == 0) {
        reader.error(2, "M11", "", "the matrix of a /TRANSFORM must not flatten the nodes: its determinant is 0",
                     "Correct the matrix");
    }
    warn_of_excess(reader, 5);
    return map;
}

Affine map_of(Reading& reading, CardReader& reader, const std::string& type) {
    if (type == "TRA") return translation(reading, reader);
    if (type == "ROT") return rotation(reading, reader);
    if (type == "SYM") return symmetry(reading, reader);
    if (type == "SCA") return scaling(reading, reader);
    return matrix(reader);
}

/// The nodes that a card moves. Reading the deck has made a group of a submodel (expand_submodels).
std::vector<int> moved_nodes(Reading& reading, CardReader& reader) {
    const int group = reading.reference(reader, 1, 1, 10, "grnod_ID", reading.groups, true);
    return group < 0 ? std::vector<int>{} : reading.model.groups[static_cast<size_t>(group)].nodes;
}

}  // namespace

/// /TRANSFORM/TRA, ROT, SYM, SCA and MATRIX, one after the other in the order of the deck. A card that mirrors the
/// nodes leaves the order of the nodes of each shell as it is, so that its normal shows to the other side.
void read_transforms(Reading& reading) {
    std::unordered_set<Id> ids;
    for (const ReadCard& entry : reading.cards) {
        if (entry.match.keyword != Keyword::transform) continue;
        CardReader reader = reading.reader(*entry.card, entry.match.words + 1);
        const std::optional<Id> id = id_of(*entry.card, entry.match.words, reader);
        if (!id) continue;
        if (!ids.insert(*id).second) {
            reader.error(-1, "id", fmt::format("{}", *id), "another /TRANSFORM has this id", "Give each its own id");
        }
        const std::vector<int> nodes = moved_nodes(reading, reader);
        const Affine map = map_of(reading, reader, entry.card->words[1]);
        reader.finish();
        for (const int node : nodes) {
            Vec3& x = reading.model.nodes.position[static_cast<size_t>(node)];
            x = map.linear * x + map.shift;
        }
    }
}

}  // namespace type21
