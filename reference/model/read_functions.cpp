#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

void read_points(CardReader& reader, Function& function) {
    for (size_t line = 1; line < reader.line_count(); ++line) {
        if (reader.blank(line, 1, 40)) continue;
        const double x = reader.real_as_written(line, 1, 20, "X");
        const double y = reader.real_as_written(line, 21, 40, "Y");
        if (!function.x.empty() && x <= function.x.back()) {
            reader.error(static_cast<int>(line), "X", fmt::format("{}", x), "the abscissae of a function ascend",
                         fmt::format("Give a value above {}, that of the point before", function.x.back()));
            continue;
        }
        function.x.push_back(x);
        function.y.push_back(y);
    }
    if (function.x.empty()) {
        reader.error(-1, "X", "", "a function has at least one point", "Add a line with X and Y");
    }
}

}  // namespace

/// /FUNCT and /SENSOR/TIME. The points of a function are pure numbers; the cards that use it scale them.
void read_functions(Reading& reading) {
    Model& model = reading.model;
    const auto next_function = [&] { return static_cast<int>(model.functions.size()); };
    reading.each(Keyword::function, reading.functions, next_function, [&](CardReader& reader, Id id) {
        Function function;
        function.id = id;
        function.title = reader.text(0, 1, 100);
        read_points(reader, function);
        model.functions.push_back(std::move(function));
    });
    const auto next_sensor = [&] { return static_cast<int>(model.sensors.size()); };
    reading.each(Keyword::sensor, reading.sensors, next_sensor, [&](CardReader& reader, Id id) {
        TimeSensor sensor;
        sensor.id = id;
        sensor.title = reader.text(0, 1, 100);
        sensor.delay = reader.real(1, 1, 20, "Tdelay", dim::time);
        if (model.version >= 2023) {
            const double stop = reader.real(2, 1, 20, "Tstop", dim::time);
            if (stop != 0) sensor.stop = stop;
        }
        warn_of_excess(reader, model.version >= 2023 ? 3 : 2);
        model.sensors.push_back(std::move(sensor));
    });
}

}  // namespace type21
