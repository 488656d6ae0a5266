#include <array>

#include <fmt/format.h>

#include "reference/model/card_reading.h"
#include "reference/model/reading.h"
#include "reference/model/selector.h"

namespace type21 {

namespace {

constexpr Dimension per_pressure{-1, 1, 2, 0};
constexpr Dimension per_pressure_squared{-2, 2, 4, 0};
constexpr Dimension per_velocity{0, -1, 1, 0};
constexpr Dimension per_velocity_squared{0, -2, 2, 0};
constexpr Dimension per_pressure_velocity{-1, 0, 3, 0};

/// Dimensions of C1..C6 by law (Formulation 8, step 3 to step 7): 0 Coulomb, 1 viscous, 2 Darmstadt, 3 Renard, 4
/// exponential.
constexpr std::array<std::array<Dimension, 6>, 5> coefficient_dimensions{
    {{},
     {{per_pressure, per_velocity, per_pressure_velocity, per_pressure_squared, per_velocity_squared, dim::none}},
     {{per_pressure_squared, per_velocity, per_pressure, per_velocity, dim::none, per_velocity}},
     {{dim::none, dim::none, dim::none, dim::none, dim::velocity, dim::velocity}},
     {{dim::none, per_velocity, dim::none, dim::none, dim::none, dim::none}}}};

/// Two lines: C1..C5; C6, Fric and VISf (the latter belongs to the viscous formulation, which TYPE21 never uses).
FrictionCoefficients coefficients(CardReader& reader, size_t line, int ifric, const CardReading& rules) {
    FrictionCoefficients read;
    const auto& dimensions = coefficient_dimensions[static_cast<size_t>(ifric)];
    for (size_t i = 0; i < 6; ++i) {
        const int first = i < 5 ? 1 + 20 * static_cast<int>(i) : 1;
        read.c[i] = reader.real(i < 5 ? line : line + 1, first, first + 19, fmt::format("C{}", i + 1), dimensions[i]);
    }
    read.fric = reader.real(line + 1, 21, 40, "Fric", dim::none);
    if (read.fric < 0) {
        reader.error(static_cast<int>(line) + 1, "Fric", fmt::format("{}", read.fric),
                     "a friction coefficient is not negative", "Give a value such as 0.1");
    }
    reader.unused(line + 1, 41, 60, 20);  // VISf
    if (ifric == 3) {
        for (const ConditionFault& fault : rules.renard_faults(read.c, reader.to())) {
            reader.error(static_cast<int>(fault.rank < 5 ? line : line + 1), fmt::format("C{}", fault.rank + 1),
                         quantity(reader, read.c[fault.rank], dimensions[fault.rank]), fault.rule, fault.remedy);
        }
    }
    return read;
}

int choice(CardReader& reader, int first, std::string_view field, int largest) {
    const Id value = reader.integer(1, first, first + 9, field);
    if (value >= 0 && value <= largest) return static_cast<int>(value);
    reader.error(1, field, fmt::format("{}", value), fmt::format("{} is one of 0 to {}", field, largest),
                 "Choose one of these");
    return 0;
}

/// One side of a pair: a part, or each part of a group.
std::vector<int> read_side(Reading& reading, CardReader& reader, size_t line, int side) {
    const std::string group_field = fmt::format("grpart_ID{}", side);
    const std::string part_field = fmt::format("part_ID{}", side);
    const int first = 1 + 10 * (side - 1);
    const Id group = reader.integer(line, first, first + 9, group_field);
    const Id part = reader.integer(line, first + 20, first + 29, part_field);
    if (group == 0) {
        const int index = reading.reference(reader, line, part_field, part, reading.parts, true);
        return index < 0 ? std::vector<int>{} : std::vector<int>{index};
    }
    if (part != 0) {
        reader.error(static_cast<int>(line), part_field, fmt::format("{}", part),
                     fmt::format("a side of a pair is a part or a group of parts; {} is given, too", group_field),
                     "Give one of them");
        return {};
    }
    const SelectionCard* card = reading.selector->find(reader, line, Family::part_group, group, group_field);
    if (card == nullptr) return {};
    const int errors = reading.problems.error_count();
    std::vector<int> parts = reading.selector->parts(*card);
    if (parts.empty() && reading.problems.error_count() == errors) {
        reader.error(static_cast<int>(line), group_field, fmt::format("{}", group), "the group has no parts",
                     "Check what the group lists, or remove the pair");
    }
    return parts;
}

/// Three lines: both sides; C1..C5; C6 and Fric. Each part of the one side with each of the other.
void read_pairs(Reading& reading, CardReader& reader, size_t line, FrictionModel& model) {
    const std::vector<int> side1 = read_side(reading, reader, line, 1);
    const std::vector<int> side2 = read_side(reading, reader, line, 2);
    refuse_unless_zero(reader, line, 51, 60, "Idir", "friction that depends on the direction is");
    const FrictionCoefficients read = coefficients(reader, line + 1, model.ifric, card_reading(reading.model.as_built));
    for (const int a : side1) {
        for (const int b : side2)
            model.pairs.push_back({a, b, read});
    }
}

}  // namespace

/// /FRICTION: the default coefficients and those of pairs of parts or groups of parts, three lines each. Of several
/// pairs that hold for two parts the first one counts.
void read_friction(Reading& reading) {
    std::vector<FrictionModel>& models = reading.model.friction_models;
    const auto next = [&] { return static_cast<int>(models.size()); };
    const CardReading rules = card_reading(reading.model.as_built);
    reading.each(Keyword::friction, reading.friction_models, next, [&](CardReader& reader, Id id) {
        FrictionModel model;
        model.id = id;
        model.title = reader.text(0, 1, 100);
        model.line = reader.line_number(reader.line_count());
        model.ifric = choice(reader, 1, "Ifric", 4);
        model.ifiltr = choice(reader, 11, "Ifiltr", 3);
        // Xfreq is a cutting frequency with Ifiltr 3 only; otherwise it is a pure number.
        const Dimension frequency = model.ifiltr == 3 ? dim::frequency : dim::none;
        model.xfreq = reader.real(1, 21, 40, "Xfreq", frequency);
        if (const auto fault = rules.filter_fault(model.ifiltr, model.xfreq))
            reader.error(1, "Xfreq", quantity(reader, model.xfreq, frequency), fault->rule, fault->remedy);
        reader.unused(1, 41, 50, 10);  // Iform
        model.fallback = coefficients(reader, 2, model.ifric, rules);
        for (size_t line = 4; line < reader.line_count(); line += 3) {
            if (reader.blank(line, 1, 100)) continue;
            if (!reader.has_line(line + 2)) {
                reader.error(static_cast<int>(line), "", "", "the card ends early: a pair of parts needs three lines",
                             "Add the lines that are missing: part_ID1 part_ID2; C1 to C5; C6 Fric VISf");
                break;
            }
            read_pairs(reading, reader, line, model);
        }
        models.push_back(std::move(model));
    });
}

}  // namespace type21
