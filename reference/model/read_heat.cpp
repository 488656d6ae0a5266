#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

constexpr int last_version_with_iform = 2021;

/// Before 2022 the card names its formulation; shells know the finite element one only.
void check_formulation(CardReader& reader, int version) {
    if (version > last_version_with_iform) {
        reader.unused(0, 81, 90, 10);
        return;
    }
    const Id form = reader.integer(0, 81, 90, "Iform");
    if (form == 1) return;
    if (form == 0)
        reader.warning(0, "Iform", "0", "shells have the finite element formulation only, it is taken",
                       "Set Iform to 1");
    else
        reader.error(0, "Iform", fmt::format("{}", form), "TYPE21 needs the finite element formulation, Iform 1",
                     "Set Iform to 1");
}

void check_solid_state(CardReader& reader, const HeatMaterial& heat) {
    if (!(heat.heat_capacity > 0))
        reader.error(0, "rho_Cp", quantity(reader, heat.heat_capacity, dim::heat_capacity),
                     "the heat capacity of a volume is positive", "Give density times specific heat");
    if (heat.conductivity_a < 0)
        reader.error(0, "A_S", quantity(reader, heat.conductivity_a, dim::conductivity),
                     "a conductivity A_S + B_S T is not negative", "Give the conductivity in the units of the deck");
    if (heat.initial_temperature < 0)
        reader.error(0, "T0", quantity(reader, heat.initial_temperature, dim::temperature),
                     "an absolute temperature is not negative", "Give it in K");
    else if (heat.initial_temperature == 0)
        reader.warning(0, "T0", quantity(reader, 0, dim::temperature),
                       "the material starts at absolute zero unless /INITEMP says otherwise", "Give T0 in K");
}

/// Melting and the heat of plastic work belong to element forces.
void note_unused(CardReader& reader) {
    constexpr double never = 1e20;  ///< a T1 from here on is not reached
    const double melting = reader.real(1, 1, 20, "T1", dim::temperature);
    const double a = reader.real(1, 21, 40, "A_L", dim::conductivity);
    const double b = reader.real(1, 41, 60, "B_L", dim::conductivity_slope);
    const double work_to_heat = reader.real(1, 61, 80, "EFRAC", dim::none);
    if ((a != 0 || b != 0) && melting != 0 && melting < never)
        reader.warning(
            1, a != 0 ? "A_L" : "B_L",
            a != 0 ? quantity(reader, a, dim::conductivity) : quantity(reader, b, dim::conductivity_slope),
            fmt::format("the conductivity of the manual page is A_S + B_S T, A_L and B_L above T1 {} are not used",
                        quantity(reader, melting, dim::temperature)),
            "Nothing needs to be done while the sheet stays below T1");
    if (work_to_heat != 0)
        reader.warning(1, "EFRAC", fmt::format("{}", work_to_heat),
                       "has no effect: no plastic work is computed, so none becomes heat", "Leave it blank");
}

}  // namespace

/// /HEAT/MAT: no title, its id is that of the material which it makes thermal.
void read_heat_materials(Reading& reading) {
    reading.conditions = {"/HEAT/MAT", {}, {}};
    reading.each(
        Keyword::material_heat, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            HeatMaterial heat;
            heat.initial_temperature = reader.real(0, 1, 20, "T0", dim::temperature);
            heat.heat_capacity = reader.real(0, 21, 40, "rho_Cp", dim::heat_capacity);
            heat.conductivity_a = reader.real(0, 41, 60, "A_S", dim::conductivity);
            heat.conductivity_b = reader.real(0, 61, 80, "B_S", dim::conductivity_slope);
            check_formulation(reader, reading.model.version);
            check_solid_state(reader, heat);
            note_unused(reader);
            warn_of_excess(reader, 2);
            const int material = reading.reference(reader, keyword_line, "mat_ID", id, reading.materials, true);
            if (material >= 0) reading.model.materials[static_cast<size_t>(material)].heat = heat;
        });
}

namespace {

void read_initial_temperatures(Reading& reading) {
    reading.conditions = {"/INITEMP", {}, {}};
    reading.each(
        Keyword::initial_temperature, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            InitialTemperature initial;
            initial.id = id;
            initial.temperature = reader.real(1, 1, 20, "T0", dim::temperature);
            initial.group = reading.reference(reader, 1, 21, 30, "grnod_ID", reading.groups, true);
            refuse_unless_zero(reader, 1, 31, 40, "fld_type", "a field of temperatures is");
            if (initial.temperature < 0)
                reader.error(1, "T0", quantity(reader, initial.temperature, dim::temperature),
                             "an absolute temperature is not negative", "Give it in K");
            warn_of_excess(reader, 2);
            reading.model.initial_temperatures.push_back(initial);
        });
}

void read_imposed_temperatures(Reading& reading) {
    reading.conditions = {"/IMPTEMP", {}, {}};
    reading.each(
        Keyword::imposed_temperature, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) {
            ImposedTemperature imposed;
            imposed.id = id;
            imposed.function = reading.reference(reader, 1, 1, 10, "fct_IDT", reading.functions, true);
            imposed.sensor = sensor_reference(reading, reader, 1, 11);
            imposed.group = reading.reference(reader, 1, 21, 30, "grnod_ID", reading.groups, true);
            imposed.scale_x = scale(reader, 2, 1, "Ascale_x", dim::time);
            imposed.scale_y = scale(reader, 2, 21, "Fscale_y", dim::temperature);
            imposed.start = reader.real(2, 41, 60, "Tstart", dim::time);
            const double stop = reader.real(2, 61, 80, "Tstop", dim::time);
            if (stop != 0) imposed.stop = stop;
            warn_of_excess(reader, 3);
            reading.model.imposed_temperatures.push_back(imposed);
        });
}

}  // namespace

/// /INITEMP and /IMPTEMP.
void read_temperatures(Reading& reading) {
    read_initial_temperatures(reading);
    read_imposed_temperatures(reading);
}

}  // namespace type21
