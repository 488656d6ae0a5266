#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

void read_initial_velocities(Reading& reading) {
    reading.conditions = {"/INIVEL", {}, {}};
    reading.each(
        Keyword::initial_velocity, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            InitialVelocity initial;
            initial.id = id;
            initial.velocity.x() = reader.real(1, 1, 20, "Vx", dim::velocity);
            initial.velocity.y() = reader.real(1, 21, 40, "Vy", dim::velocity);
            initial.velocity.z() = reader.real(1, 41, 60, "Vz", dim::velocity);
            initial.group = reading.reference(reader, 1, 61, 70, "grnod_ID", reading.groups, true);
            refuse_unless_zero(reader, 1, 71, 80, "skew_ID", "local axes are");
            const bool with_start = reading.model.version >= 2025;
            if (with_start) {
                const double start = reader.real(2, 1, 20, "Tstart", dim::time);
                if (start != 0) {
                    reader.error(2, "Tstart", quantity(reader, start, dim::time),
                                 "an initial velocity that acts later is not supported", "Set it to 0");
                }
                refuse_unless_zero(reader, 2, 21, 30, "sens_ID", "an initial velocity on a sensor is");
            }
            warn_of_excess(reader, with_start ? 3 : 2);
            reading.model.initial_velocities.push_back(initial);
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
            refuse_unless_zero(reader, 1, 21, 30, "skew_ID", "local axes are");
            load.sensor = reading.reference(reader, 1, 31, 40, "sens_ID", reading.sensors, false);
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

/// /INIVEL/TRA, /ADMAS and /CLOAD.
void read_loads(Reading& reading) {
    read_initial_velocities(reading);
    read_added_masses(reading);
    read_forces(reading);
}

}  // namespace type21
