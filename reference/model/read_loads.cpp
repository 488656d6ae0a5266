#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

/// Direction X, Y, Z as 0..2; -1 and an error for another word.
int translation_direction(CardReader& reader, size_t line, int first, int last) {
    const int found = direction(reader, line, first, last);
    if (found < 3) return found;
    reader.error(static_cast<int>(line), "Dir", reader.text(line, first, last), "the direction is one of X, Y, Z",
                 fmt::format("Write it in columns {} to {}", first, last));
    return -1;
}

/// From version 2025 on a second line lets the velocity act later.
void read_start(Reading& reading, CardReader& reader, size_t line) {
    const bool with_start = reading.model.version >= 2025;
    if (with_start) {
        const double start = reader.real(line, 1, 20, "Tstart", dim::time);
        if (start != 0) {
            reader.error(static_cast<int>(line), "Tstart", quantity(reader, start, dim::time),
                         "an initial velocity that acts later is not supported", "Set it to 0");
        }
        refuse_unless_zero(reader, line, 21, 30, "sens_ID", "an initial velocity on a sensor is");
    }
    warn_of_excess(reader, with_start ? line + 1 : line);
}

Vec3 components(CardReader& reader, size_t line, const std::array<std::string_view, 3>& names, Dimension dimension) {
    return {reader.real(line, 1, 20, names[0], dimension), reader.real(line, 21, 40, names[1], dimension),
            reader.real(line, 41, 60, names[2], dimension)};
}

Mat3 axes_of(const Model& model, int skew) {
    return skew < 0 ? Mat3(Mat3::Identity()) : model.skews[static_cast<size_t>(skew)].axes;
}

/// /INIVEL/TRA and /INIVEL/ROT: three components in the axes of a skew.
void read_initial_components(Reading& reading, Keyword keyword, const char* name, InitialVelocity::Kind kind) {
    reading.conditions = {name, {}, {}};
    reading.each(
        keyword, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            InitialVelocity initial;
            initial.id = id;
            initial.kind = kind;
            const bool translation = kind == InitialVelocity::Kind::translation;
            const Vec3 local = translation ? components(reader, 1, {"Vx", "Vy", "Vz"}, dim::velocity)
                                           : components(reader, 1, {"VRx", "VRy", "VRz"}, dim::frequency);
            initial.group = reading.reference(reader, 1, 61, 70, "grnod_ID", reading.groups, true);
            const int skew = skew_reference(reading, reader, 1, 71, "skew_ID", reading.skews);
            // Without a skew the components stay what they are, to the last bit.
            (translation ? initial.velocity : initial.angular_velocity) =
                skew < 0 ? local : Vec3(axes_of(reading.model, skew) * local);
            read_start(reading, reader, 2);
            reading.model.initial_velocities.push_back(initial);
        });
}

/// /INIVEL/AXIS: a velocity and a rotation about an axis of a frame, through its origin.
void read_initial_axes(Reading& reading) {
    reading.conditions = {"/INIVEL/AXIS", {}, {}};
    reading.each(
        Keyword::initial_axis, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            InitialVelocity initial;
            initial.id = id;
            initial.kind = InitialVelocity::Kind::axis;
            const int axis = translation_direction(reader, 1, 1, 10);
            const int frame = skew_reference(reading, reader, 1, 11, "frame_ID", reading.frames);
            initial.group = reading.reference(reader, 1, 21, 30, "grnod_ID", reading.groups, true);
            const Vec3 local = components(reader, 2, {"Vxt", "Vyt", "Vzt"}, dim::velocity);
            const double rate = reader.real(2, 61, 80, "Vr", dim::frequency);
            read_start(reading, reader, 3);
            const Mat3 axes = axes_of(reading.model, frame);
            if (frame >= 0) initial.origin = reading.model.skews[static_cast<size_t>(frame)].origin;
            initial.velocity = axes * local;
            if (axis >= 0) initial.angular_velocity = rate * axes.col(axis);
            reading.model.initial_velocities.push_back(initial);
        });
}

void read_gravities(Reading& reading) {
    reading.conditions = {"/GRAV", {}, {}};
    reading.each(
        Keyword::gravity, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            Gravity gravity;
            gravity.id = id;
            gravity.function = reading.reference(reader, 1, 1, 10, "fct_IDT", reading.functions, false);
            gravity.direction = translation_direction(reader, 1, 11, 20);
            gravity.skew = skew_reference(reading, reader, 1, 21, "skew_ID", reading.skews);
            gravity.sensor = sensor_reference(reading, reader, 1, 31);
            gravity.group = reading.reference(reader, 1, 41, 50, "grnod_ID", reading.groups, false);
            gravity.scale_x = scale(reader, 1, 61, "Ascale_x", dim::time);
            gravity.scale_y = scale(reader, 1, 81, "Fscale_y", dim::acceleration);
            warn_of_excess(reader, 2);
            reading.model.gravities.push_back(gravity);
        });
}

void read_added_masses(Reading& reading) {
    const auto read = [&](Keyword keyword, bool shared) {
        reading.each(
            keyword, reading.conditions, [] { return 0; },
            [&](CardReader& reader, Id id) {
                AddedMass added;
                added.id = id;
                added.shared = shared;
                added.mass = reader.real(1, 1, 20, "Mass", dim::mass);
                added.group = reading.reference(reader, 1, 21, 30, "grnod_ID", reading.groups, true);
                if (added.mass < 0) {
                    reader.error(1, "Mass", quantity(reader, added.mass, dim::mass), "an added mass is not negative",
                                 "Lower the density instead");
                }
                warn_of_excess(reader, 2);
                reading.model.added_masses.push_back(added);
            });
    };
    reading.conditions = {"/ADMAS", {}, {}};
    read(Keyword::added_mass_each, false);
    read(Keyword::added_mass_shared, true);
}

void read_forces(Reading& reading) {
    reading.conditions = {"/CLOAD", {}, {}};
    reading.each(
        Keyword::load, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            ConcentratedLoad load;
            load.id = id;
            load.function = reading.reference(reader, 1, 1, 10, "fct_IDT", reading.functions, true);
            load.direction = direction(reader, 1, 11, 20);
            load.skew = skew_reference(reading, reader, 1, 21, "skew_ID", reading.skews);
            load.sensor = sensor_reference(reading, reader, 1, 31);
            load.group = reading.reference(reader, 1, 41, 50, "grnod_ID", reading.groups, true);
            if (reading.model.version >= 2023) {  // older cards leave these columns blank
                const Id type = reader.integer(1, 51, 60, "Itypfun");
                if (type != 0 && type != 1) {
                    reader.error(1, "Itypfun", fmt::format("{}", type), "only loads as functions of time are supported",
                                 "Set it to 1");
                }
            }
            load.scale_x = scale(reader, 1, 61, "Ascale_x", dim::time);
            load.scale_y = scale(reader, 1, 81, "Fscale_y", load.direction < 3 ? dim::force : dim::moment);
            warn_of_excess(reader, 2);
            reading.model.loads.push_back(load);
        });
}

}  // namespace

/// /INIVEL, /ADMAS, /CLOAD and /GRAV.
void read_loads(Reading& reading) {
    using Kind = InitialVelocity::Kind;
    read_initial_components(reading, Keyword::initial_translation, "/INIVEL/TRA", Kind::translation);
    read_initial_components(reading, Keyword::initial_rotation, "/INIVEL/ROT", Kind::rotation);
    read_initial_axes(reading);
    read_added_masses(reading);
    read_forces(reading);
    read_gravities(reading);
}

}  // namespace type21
