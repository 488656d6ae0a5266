#include <algorithm>
#include <functional>
#include <utility>

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

/// Scale of an axis of /MOVE_FUNCT; blank or 0 is 1.
double scale_of_axis(CardReader& reader, int first, std::string_view field) {
    const double value = reader.real_as_written(1, first, first + 19, field);
    return value != 0 ? value : 1.0;
}

/// x Ascale_x + Ashift_x and y Fscale_y + Fshift_y for every point. Pure numbers, like the points.
void move(Reading& reading, CardReader& reader, Id id) {
    const double scale_x = scale_of_axis(reader, 1, "Ascale_x");
    const double scale_y = scale_of_axis(reader, 21, "Fscale_y");
    const double shift_x = reader.real_as_written(1, 41, 60, "Ashift_x");
    const double shift_y = reader.real_as_written(1, 61, 80, "Fshift_y");
    warn_of_excess(reader, 2);
    if (!(scale_x > 0)) {
        reader.error(1, "Ascale_x", fmt::format("{}", scale_x), "the abscissae of a function ascend, also when scaled",
                     "Give a scale above 0, or 0 for 1");
        return;
    }
    const int index = reading.reference(reader, keyword_line, "fct_ID", id, reading.functions, true);
    if (index < 0) return;
    Function& function = reading.model.functions[static_cast<size_t>(index)];
    for (double& x : function.x)
        x = x * scale_x + shift_x;
    for (double& y : function.y)
        y = y * scale_y + shift_y;
    const auto same = std::adjacent_find(function.x.begin(), function.x.end(), std::greater_equal<>());
    if (same != function.x.end()) {
        reader.error(1, "Ashift_x", fmt::format("{}", shift_x),
                     fmt::format("two abscissae of the function become the same number, {}", *same),
                     "Give a smaller shift or a larger scale");
    }
}

}  // namespace

/// /FUNCT, then /MOVE_FUNCT, which changes the points of the function with its id. The points of a function are pure
/// numbers; the cards that use it scale them.
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
    reading.conditions = {"/MOVE_FUNCT", {}, {}};
    reading.each(
        Keyword::move_function, reading.conditions, [] { return 0; },
        [&](CardReader& reader, Id id) { move(reading, reader, id); });
}

}  // namespace type21
