/// @file Lines 6 to 8: friction and the sensor.
#include "verification/explain/field_help.h"

namespace type21 {

std::vector<FieldHelp> field_help_friction() {
    using enum Departure;
    return {
        {"Ifric",
         "Friction law, with p the pressure F_n / A and s the sliding speed.",
         "0: mu = Fric (Coulomb). 1: Fric + C1 p + C2 s + C3 p s + C4 p^2 + C5 s^2. 2: Fric + C1 e^(C2 s) p^2 + "
         "C3 e^(C4 s) p + C5 e^(C6 s). 3: Renard. 4: C1 + (Fric - C1) e^(-C2 s), not on the manual page.",
         "manual page, comments 12 and 13, equations (7) to (11); Formulation 8, step 3; Formulation 8, step 4; "
         "Formulation 8, step 5; Formulation 8, step 6; Formulation 8, step 7",
         {D10, D17, D21, D43}},
        {"Ifiltr",
         "Filter of the friction force: T = F_old + alpha k v dt.",
         "0: alpha = 1. 1: alpha = Xfreq. 2: alpha = 2 pi Xfreq. 3: alpha = 2 pi Xfreq dt. Never above 1.",
         "manual page, comment 15, equation (13); Formulation 8, step 8",
         {D06, D07, D28}},
        {"Xfreq",
         "Constant of the friction filter.",
         "Ifiltr 1 and 2: between 0 and 1; for 2 the time step over the filter period. Ifiltr 3: the cutting "
         "frequency. 0 means no filter.",
         "manual page, comment 15, equation (13); Formulation 8, step 8",
         {D06, D07, D28}},
        {"sens_ID",
         "Sensor that switches the interface on and off.",
         "With it Tstart and Tstop are not used.",
         "manual page, comment 20; Formulation 9, step 2",
         {D09}},
        {"fct_IDF",
         "Function of temperature that scales the friction coefficient of law 0.",
         "mu = Fric f(AscaleF (T_s + T_m) / 2), at least 0. Needs Ithe. Not used with fric_ID.",
         "manual page, comment 12, equations (7) and (8); Formulation 8, step 3",
         {D08, D39}},
        {"AscaleF",
         "Factor on the temperature at which fct_IDF is taken.",
         "Used with fct_IDF.",
         "manual page, definitions, equation (8); Formulation 8, step 3",
         {D08}},
        {"fric_ID",
         "/FRICTION that replaces the friction fields of the card, by pairs of parts.",
         "Its Ifric, Ifiltr, Xfreq, Fric and C1 to C6 apply: those of the listed pair, otherwise its default.",
         "not on the manual page (later than it); Formulation 8, step 1",
         {D21, D28, D42}},
        {"C1",
         "First coefficient of the friction law.",
         "Ifric 1: factor of p. 2: factor of the p^2 term. 3: static coefficient. 4: coefficient at high speed.",
         "manual page, comment 13, equations (10) and (11); Formulation 8, step 4; Formulation 8, step 5; Formulation "
         "8, step 6; Formulation 8, step 7",
         {D10, D17, D21, D43}},
        {"C2",
         "Second coefficient of the friction law.",
         "Ifric 1: factor of s. 2: exponent of the p^2 term. 3: dynamic coefficient. 4: exponent.",
         "manual page, comment 13, equations (10) and (11); Formulation 8, step 4; Formulation 8, step 5; Formulation "
         "8, step 6; Formulation 8, step 7",
         {D10, D17, D21, D43}},
        {"C3",
         "Third coefficient of the friction law.",
         "Ifric 1: factor of p s. 2: factor of the p term. 3: largest coefficient, at the speed C5; C1 and C2 lie "
         "below.",
         "manual page, comment 13, equations (10) and (11); Formulation 8, step 4; Formulation 8, step 5; Formulation "
         "8, step 6",
         {D17, D21, D43}},
        {"C4",
         "Fourth coefficient of the friction law.",
         "Ifric 1: factor of p^2. 2: exponent of the p term. 3: least coefficient, at the speed C6; C1 and C2 lie "
         "above.",
         "manual page, comment 13, equations (10) and (11); Formulation 8, step 4; Formulation 8, step 5; Formulation "
         "8, step 6",
         {D17, D21, D43}},
        {"C5",
         "Fifth coefficient of the friction law.",
         "Ifric 1: factor of s^2. 2: factor of the last term. 3: first critical speed, > 0 and < C6.",
         "manual page, comment 13, equations (10) and (11); Formulation 8, step 4; Formulation 8, step 5; Formulation "
         "8, step 6",
         {D17, D21, D43}},
        {"C6",
         "Sixth coefficient of the friction law.",
         "Ifric 2: exponent of the last term. 3: second critical speed. Not used by the others.",
         "manual page, comment 13, equation (11); Formulation 8, step 5; Formulation 8, step 6",
         {D17, D21, D43}},
    };
}

}  // namespace type21
