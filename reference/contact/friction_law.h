/// @file Friction coefficient as a function of pressure and speed (Formulation 8, step 1 to step 7).
#pragma once

#include "reference/contract/scene.h"

namespace type21::reference {

/// The smallest coefficient of laws 1 to 4 [-].
inline constexpr double smallest_friction_coefficient = 1e-30;

/// Coulomb, Ifric 0: mu = Fric
/// Generalised viscous, Ifric 1, equation (10):
///   mu = Fric + C1 p + C2 s + C3 p s + C4 p^2 + C5 s^2
/// Modified Darmstadt, Ifric 2, equation (11):
///   mu = Fric + C1 e^(C2 s) p^2 + C3 e^(C4 s) p + C5 e^(C6 s)
/// Renard, Ifric 3: static C1, dynamic C2, maximum C3 at the speed C5, minimum C4 at the speed C6:
///   s <= C5:      C1 + (C3 - C1) x (2 - x),           x = s / C5
///   C5 < s < C6:  C3 + (C4 - C3) y^2 (3 - 2 y),       y = (s - C5) / (C6 - C5)
///   s >= C6:      C2 - 1 / (1 / (C2 - C4) + (s - C6)^2)
/// Exponential, Ifric 4 (not on the manual page): mu = C1 + (Fric - C1) e^(-C2 s)
/// Laws 1 to 4 are raised to at least smallest_friction_coefficient, law 0 to at least 0, which fct_IDF may undercut. A
/// term whose coefficient or pressure is 0 is 0, also when its exponential or square overflows.
/// @param ifric         0 to 4; another value acts as 0
/// @param coefficients  Fric and C1..C6, in the units that the law asks for; they are not checked here
/// @param pressure      F_n / A, damping included, negative where the damping pulls [pressure]
/// @param speed         s = |v - v_n nu|, >= 0 [velocity]
/// @return mu [-]; not finite where a term overflows.  Formulation 8, step 3 to step 7; manual page, comments 12 and
/// 13; as built: D10, D39, D43.
/// @manual eq 9, 10, 11; field Ifric, Fric, C1, C2, C3, C4, C5, C6; comment 12, 13
double friction_coefficient(int ifric, const FrictionCoefficients& coefficients, double pressure, double speed);

/// Which of C1..C6 makes a coefficient that is not finite.
/// @return its rank, from 0.  Formulation 8, step 7.
size_t overflowing_coefficient(int ifric, const FrictionCoefficients& coefficients, double speed);

/// Coefficients of the card, or of the /FRICTION that replaces it: of the listed pair of parts, or else its default.
/// @param part_secondary  index into ContactModel::parts of the node's part, -1: none
/// @param part_main       of the main segment's part, -1: none
/// @return Fric and C1..C6.  Formulation 8, step 1.
/// @manual field fric_ID
FrictionCoefficients friction_coefficients(const ContactModel& model, const Interface& interface, int part_secondary,
                                           int part_main);

/// Temperature at which fct_IDF is taken: AscaleF times the mean of both sides.
/// @param blank  T_s [temperature]
/// @param tool   T_m [temperature]
/// @return abscissa of fct_IDF.  Formulation 8, step 3; manual page, comment 12, equation (8); as built: D08.
/// @manual eq 7, 8; field fct_IDF, AscaleF; comment 12
double friction_temperature(const Interface& interface, double blank, double tool);

}  // namespace type21::reference
