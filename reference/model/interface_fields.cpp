/// @file The table of fields, as the manual page lays them out.
#include "reference/model/interface_fields.h"

namespace type21 {
namespace {

constexpr Dimension operator-(Dimension d) {
    return {-d.mass, -d.length, -d.time, -d.temperature};
}
constexpr Dimension operator+(Dimension a, Dimension b) {
    return {a.mass + b.mass, a.length + b.length, a.time + b.time, a.temperature + b.temperature};
}

/// Dimension of C1..C6 (manual page, comment 13, table 1); Ifric 4 from its formula.
Dimension friction_dimension(int ifric, size_t rank) {
    constexpr Dimension one = dim::none;
    constexpr Dimension v = dim::velocity;
    constexpr Dimension per_p = -dim::pressure;
    constexpr Dimension per_v = -dim::velocity;
    constexpr Dimension table[4][6] = {{per_p, per_v, per_p + per_v, per_p + per_p, per_v + per_v, one},
                                       {per_p + per_p, per_v, per_p, per_v, one, per_v},
                                       {one, one, one, one, v, v},
                                       {one, per_v, one, one, one, one}};
    if (ifric < 1 || ifric > 4) return one;
    return table[ifric - 1][rank];
}

}  // namespace

const std::vector<InterfaceField>& interface_fields() {
    using I = Interface;
    static const std::vector<InterfaceField> fields{
        {1, 1, 10, "surf_IDs", &I::surf_secondary},
        {1, 11, 20, "surf_IDm", &I::surf_main},
        {1, 21, 30, "Istf", &I::istf},
        {1, 31, 40, "Ithe", &I::ithe},
        {1, 41, 50, "Igap", &I::igap},
        {1, 71, 80, "Idel", &I::idel, dim::none, 2019},
        {1, 81, 90, "Invn", &I::invn, dim::none, 2017},
        {1, 91, 100, "Iadm", &I::iadm},
        {2, 1, 20, "Fscalegap", &I::fscalegap},
        {2, 21, 40, "Gapmax", &I::gapmax, dim::length},
        {2, 41, 60, "DEPTH", &I::depth, dim::length},
        {2, 61, 80, "Pmax", &I::pmax, dim::pressure},
        {2, 81, 90, "ITlim", &I::itlim, dim::none, 2017},
        {3, 1, 20, "Stmin", &I::stmin, dim::stiffness},
        {3, 21, 40, "Stmax", &I::stmax, dim::stiffness},
        {3, 61, 80, "Pskid", &I::pskid, dim::pressure, 2020},
        {4, 1, 20, "Stfac", &I::stfac},
        {4, 21, 40, "Fric", &I::fric},
        {4, 41, 60, "Gapmin", &I::gapmin, dim::length},
        {4, 61, 80, "Tstart", &I::tstart, dim::time},
        {4, 81, 100, "Tstop", &I::tstop, dim::time},
        {5, 8, 10, "IBC", &I::ibc},
        {5, 31, 40, "Inacti", &I::inacti},
        {5, 41, 60, "VISs", &I::viss},
        {5, 81, 100, "Bumult", &I::bumult},
        {6, 1, 10, "Ifric", &I::ifric},
        {6, 11, 20, "Ifiltr", &I::ifiltr},
        {6, 21, 40, "Xfreq", &I::xfreq},
        {6, 51, 60, "sens_ID", &I::sens_id},
        {6, 61, 70, "fct_IDF", &I::fct_idf, dim::none, 140},
        {6, 71, 90, "AscaleF", &I::ascalef, dim::temperature, 140},
        {6, 91, 100, "fric_ID", &I::fric_id, dim::none, 2025},
        {7, 1, 20, "C1", size_t{0}},
        {7, 21, 40, "C2", size_t{1}},
        {7, 41, 60, "C3", size_t{2}},
        {7, 61, 80, "C4", size_t{3}},
        {7, 81, 100, "C5", size_t{4}},
        {8, 1, 20, "C6", size_t{5}},
        {9, 1, 10, "NRadm", &I::nradm},
        {9, 11, 30, "Padm", &I::padm},
        {9, 31, 50, "Angladm", &I::angladm},
        {10, 1, 20, "Kthe", &I::kthe, dim::conductance},
        {10, 21, 30, "fct_IDK", &I::fct_idk},
        {10, 31, 50, "AscaleK", &I::ascalek, dim::pressure},
        {10, 51, 70, "Tint", &I::tint, dim::temperature},
        {10, 71, 80, "Ithe_form", &I::ithe_form, dim::none, 2017},
        {11, 1, 20, "Frad", &I::frad, dim::radiation},
        {11, 21, 40, "Drad", &I::drad, dim::length},
        {11, 41, 60, "Fheat", &I::fheat, dim::none, 140},
        {11, 71, 80, "Fcond", &I::fcond, dim::none, 2021},
        {11, 81, 100, "Dcond", &I::dcond, dim::length, 2021},
        {12, 1, 10, "IDrby", &I::idrby},
        {12, 11, 20, "IDref", &I::idref},
        {12, 21, 40, "Damp", &I::damp},
        {12, 41, 60, "Dampr", &I::dampr},
    };
    return fields;
}

Dimension dimension(const InterfaceField& field, const Interface& interface) {
    if (const size_t* rank = std::get_if<size_t>(&field.member)) return friction_dimension(interface.ifric, *rank);
    if (field.name == "Stfac") return interface.istf == 1 ? dim::stiffness : dim::none;
    if (field.name == "Xfreq") return interface.ifiltr == 3 ? dim::frequency : dim::none;
    return field.fixed;
}

}  // namespace type21
