/// @file Numbers as programs print them, and what their digits tell.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace type21 {

/// Reads the numbers of one file and remembers how they are written.
class CsvNumbers {
  public:
    /// @param decimal_comma  a comma may stand for the decimal point
    explicit CsvNumbers(bool decimal_comma) : decimal_comma_(decimal_comma) {}

    /// 1.5, +1.5E-3, 1.5D-3, 1,5 with decimal commas, nan, inf. What is too small for a double is 0.
    /// @return nothing when it is no number, or too large for a double
    std::optional<double> read(std::string_view cell, std::size_t line);
    /// The same, and its digits count for printed_digits().
    std::optional<double> read_value(std::string_view cell, std::size_t line);

    /// What is wrong with the file as a whole, such as decimal commas beside decimal points; empty if nothing is.
    std::string fault() const;
    bool has_decimal_comma() const { return comma_line_ > 0; }
    /// Significant digits to which the values were printed, 4 to 14; 0 where no such number shows.
    int printed_digits() const;

  private:
    void count_digits(std::string_view cell);

    bool decimal_comma_;
    std::size_t comma_line_ = 0, point_line_ = 0;
    bool comma_is_clear_ = false;
    long values_ = 0;  ///< that are not 0
    int most_digits_ = 0, fewest_digits_ = 1000;
    long with_most_ = 0;
    bool all_scientific_ = true;
};

}  // namespace type21
