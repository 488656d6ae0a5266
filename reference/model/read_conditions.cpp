#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

/// Columns 4 to 6 fix translations X Y Z, 8 to 10 rotations, each with a 0 or a 1.
void read_codes(CardReader& reader, std::array<bool, 6>& fixed) {
    constexpr std::array<int, 6> columns{4, 5, 6, 8, 9, 10};
    for (size_t i = 0; i < columns.size(); ++i) {
        const std::string digit = reader.text(1, columns[i], columns[i]);
        fixed[i] = digit == "1";
        if (digit == "1" || digit == "0" || digit.empty()) continue;
        reader.error(1, "Tra rot", reader.text(1, 1, 10), "a boundary condition is written with 0 and 1",
                     "Write translations in columns 4 to 6, rotations in columns 8 to 10, as in \"   111 001\"");
        return;
    }
    if (!reader.blank(1, 1, 3) || !reader.blank(1, 7, 7)) {
        reader.error(1, "Tra rot", reader.text(1, 1, 10), "columns 1 to 3 and 7 of a boundary condition are blank",
                     "Write translations in columns 4 to 6, rotations in columns 8 to 10, as in \"   111 001\"");
    }
}

void read_boundary_conditions(Reading& reading) {
    reading.conditions = {"/BCS", {}, {}};
    reading.each(
        Keyword::boundary_condition, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            BoundaryCondition condition;
            condition.id = id;
            read_codes(reader, condition.fixed);
            condition.skew = skew_reference(reading, reader, 1, 11, "skew_ID", reading.skews);
            condition.group = reading.reference(reader, 1, 21, 30, "grnod_ID", reading.groups, true);
            warn_of_excess(reader, 2);
            reading.model.boundary_conditions.push_back(condition);
        });
}

/// Dimension of the ordinate: a rotation is in radians.
Dimension ordinate(ImposedMotion::Kind kind, int direction) {
    const bool translation = direction < 3;
    if (kind == ImposedMotion::Kind::velocity) return translation ? dim::velocity : dim::frequency;
    if (kind == ImposedMotion::Kind::acceleration) return translation ? dim::acceleration : dim::angular_acceleration;
    return translation ? dim::length : dim::none;
}

/// The axes of skew_ID, or those of frame_ID: a frame that does not move gives directions only.
int axes_of_motion(Reading& reading, CardReader& reader, bool with_frame) {
    const int skew = skew_reference(reading, reader, 1, 21, "skew_ID", reading.skews);
    if (!with_frame) return skew;
    const int frame = skew_reference(reading, reader, 1, 51, "frame_ID", reading.frames);
    if (skew < 0 || frame < 0) return std::max(skew, frame);
    reader.error(1, "frame_ID", reader.text(1, 51, 60), "a motion is given in the axes of a skew or of a frame",
                 "Set skew_ID or frame_ID to 0");
    return skew;
}

void read_imposed(Reading& reading, Keyword keyword, const std::string& name, ImposedMotion::Kind kind) {
    reading.conditions = {name, {}, {}};
    reading.each(
        keyword, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            ImposedMotion motion;
            motion.id = id;
            motion.kind = kind;
            motion.function = reading.reference(reader, 1, 1, 10, "fct_IDT", reading.functions, true);
            motion.direction = direction(reader, 1, 11, 20);
            const bool with_frame = kind != ImposedMotion::Kind::acceleration;
            motion.skew = axes_of_motion(reading, reader, with_frame);
            motion.sensor = sensor_reference(reading, reader, 1, 31);
            motion.group = reading.reference(reader, 1, 41, 50, "grnod_ID", reading.groups, true);
            if (with_frame) refuse_unless_zero(reader, 1, 61, 70, "Icoor", "cylindrical axes are");
            motion.scale_x = scale(reader, 2, 1, "Ascale_x", dim::time);
            motion.scale_y = scale(reader, 2, 21, "Fscale_y", ordinate(kind, motion.direction));
            motion.start = reader.real(2, 41, 60, "Tstart", dim::time);
            const double stop = reader.real(2, 61, 80, "Tstop", dim::time);
            if (stop != 0) motion.stop = stop;
            warn_of_excess(reader, 3);
            reading.model.imposed_motions.push_back(motion);
        });
}

}  // namespace

double scale(CardReader& reader, size_t line, int first, std::string_view field, Dimension dimension) {
    const double value = reader.real(line, first, first + 19, field, dimension);
    return value != 0 ? value : conversion(reader.from(), reader.to(), dimension);
}

/// /BCS, /IMPVEL, /IMPDISP and /IMPACC.
void read_conditions(Reading& reading) {
    read_boundary_conditions(reading);
    read_imposed(reading, Keyword::imposed_velocity, "/IMPVEL", ImposedMotion::Kind::velocity);
    read_imposed(reading, Keyword::imposed_displacement, "/IMPDISP", ImposedMotion::Kind::displacement);
    read_imposed(reading, Keyword::imposed_acceleration, "/IMPACC", ImposedMotion::Kind::acceleration);
}

}  // namespace type21
