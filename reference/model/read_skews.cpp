#include <fmt/format.h>

#include "reference/model/numbers.h"
#include "reference/model/reading.h"

namespace type21 {

namespace {

Vec3 vector_of(CardReader& reader, size_t line, const std::array<std::string_view, 3>& fields, Dimension dimension) {
    return {reader.real(line, 1, 20, fields[0], dimension), reader.real(line, 21, 40, fields[1], dimension),
            reader.real(line, 41, 60, fields[2], dimension)};
}

/// X' = Y' x Z', then Z' = X' x Y': Y' keeps its direction, Z' is turned into the plane at right angles to it.
/// @return columns X', Y', Z' of length 1; none where Y' and Z' span no plane
std::optional<Mat3> triad(const Vec3& y_given, const Vec3& z_given) {
    constexpr double least_sine = 1e-10;  // below it the digits of a deck no longer fix the plane
    if (!(y_given.norm() > 0) || !(z_given.norm() > 0)) return std::nullopt;
    const Vec3 y = y_given.normalized();
    const Vec3 x = y.cross(z_given.normalized());
    if (!(x.norm() > least_sine)) return std::nullopt;
    Mat3 axes;
    axes.col(0) = x.normalized();
    axes.col(1) = y;
    axes.col(2) = axes.col(0).cross(y);
    return axes;
}

void read_fixed(Reading& reading, Keyword keyword, Registry& registry) {
    const auto next = [&] { return static_cast<int>(reading.model.skews.size()); };
    reading.each(keyword, registry, next, [&](CardReader& reader, Id id) {
        Skew skew;
        skew.id = id;
        skew.title = reader.text(0, 1, 100);
        skew.origin = vector_of(reader, 1, {"Ox", "Oy", "Oz"}, dim::length);
        const Vec3 y = vector_of(reader, 2, {"X1", "Y1", "Z1"}, dim::none);
        const Vec3 z = vector_of(reader, 3, {"X2", "Y2", "Z2"}, dim::none);
        if (const auto axes = triad(y, z)) {
            skew.axes = *axes;
        } else {
            registry.refused.emplace(
                id, fmt::format("the axes Y' ({}, {}, {}) and Z' ({}, {}, {}) of this {} are 0 or parallel", y.x(),
                                y.y(), y.z(), z.x(), z.y(), z.z(), registry.keyword));
        }
        warn_of_excess(reader, 4);
        reading.model.skews.push_back(std::move(skew));
    });
}

/// Notes skews and frames of other kinds: harmless until a card refers to one.
void note_others(Reading& reading, std::string_view word, Registry& registry) {
    for (const ReadCard& entry : reading.cards) {
        const Card& card = *entry.card;
        if (entry.match.keyword != Keyword::definition || card.words[0] != word || card.words.size() < 3) continue;
        Id id = 0;
        if (parse_integer(card.words[2], id) != NumberFault::none) continue;
        registry.refused.emplace(
            id, fmt::format("this is a /{}/{}: only axes that do not move are supported", word, card.words[1]));
    }
}

}  // namespace

/// /SKEW/FIX and /FRAME/FIX. What is wrong with one is said where a card uses it. A frame that does not move is a skew
/// with another name, so both stand in Model::skews.
void read_skews(Reading& reading) {
    read_fixed(reading, Keyword::skew_fixed, reading.skews);
    read_fixed(reading, Keyword::frame_fixed, reading.frames);
    note_others(reading, "SKEW", reading.skews);
    note_others(reading, "FRAME", reading.frames);
}

int skew_reference(Reading& reading, CardReader& reader, size_t line, int first, std::string_view field,
                   const Registry& registry) {
    const Id id = reader.integer(line, first, first + 9, field);
    if (const auto other = registry.refused.find(id); other != registry.refused.end()) {
        reader.error(static_cast<int>(line), field, fmt::format("{}", id), other->second,
                     fmt::format("Give the axes as a {}/FIX with a Y' and a vector in the plane of Y' and Z'",
                                 registry.keyword));
        return -1;
    }
    return reading.reference(reader, line, field, id, registry, false);
}

}  // namespace type21
