/// @file Units: every number of a deck has a dimension, every message that shows one names its unit.
#pragma once

#include <string>

namespace type21 {

/// Exponents of mass, length, time and temperature.
struct Dimension {
    int mass = 0;
    int length = 0;
    int time = 0;
    int temperature = 0;
    bool operator==(const Dimension&) const = default;
};

namespace dim {
inline constexpr Dimension none{};
inline constexpr Dimension mass{1, 0, 0, 0};
inline constexpr Dimension length{0, 1, 0, 0};
inline constexpr Dimension time{0, 0, 1, 0};
inline constexpr Dimension temperature{0, 0, 0, 1};
inline constexpr Dimension area{0, 2, 0, 0};
inline constexpr Dimension velocity{0, 1, -1, 0};
inline constexpr Dimension acceleration{0, 1, -2, 0};
inline constexpr Dimension frequency{0, 0, -1, 0};
inline constexpr Dimension angular_acceleration{0, 0, -2, 0};
inline constexpr Dimension density{1, -3, 0, 0};
inline constexpr Dimension force{1, 1, -2, 0};
inline constexpr Dimension moment{1, 2, -2, 0};
inline constexpr Dimension energy{1, 2, -2, 0};
inline constexpr Dimension pressure{1, -1, -2, 0};
inline constexpr Dimension stiffness{1, 0, -2, 0};
inline constexpr Dimension inertia{1, 2, 0, 0};
inline constexpr Dimension heat_capacity{1, -1, -2, -1};      ///< of a volume, J/(m^3 K)
inline constexpr Dimension conductivity{1, 1, -3, -1};        ///< W/(m K)
inline constexpr Dimension conductivity_slope{1, 1, -3, -2};  ///< W/(m K^2)
inline constexpr Dimension conductance{1, 0, -3, -1};         ///< heat exchange coefficient, W/(m^2 K)
inline constexpr Dimension radiation{1, 0, -3, -4};           ///< Stefan-Boltzmann like, W/(m^2 K^4)
}  // namespace dim

/// A unit system: how many kg, m and s one unit is, and how the deck writes it.
struct UnitSystem {
    double mass = 1.0;
    double length = 1.0;
    double time = 1.0;
    std::string mass_name = "kg";
    std::string length_name = "m";
    std::string time_name = "s";
    bool named =
        true;  ///< false: the deck names no units; the names are letters of dimensions and the sizes mean nothing

    /// Size of one unit of this dimension in SI.
    double si(Dimension dimension) const;
    /// "Mg/s^2", "mm", "1/s", ... ; empty for a pure number.
    std::string name(Dimension dimension) const;
};

/// Factor that turns a number in `from` into the same quantity in `to`.
double conversion(const UnitSystem& from, const UnitSystem& to, Dimension dimension);

/// Size in SI of a unit as Radioss decks write it ("Mg", "mm", "ms", "kg", "1e-3", ...); 0 when it is not one.
double mass_unit(const std::string& text);
double length_unit(const std::string& text);
double time_unit(const std::string& text);

}  // namespace type21
