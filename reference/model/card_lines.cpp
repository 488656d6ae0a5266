#include "reference/model/card_lines.h"

#include <map>

namespace type21 {

namespace {

using Lines = std::vector<std::string_view>;

/// One row a card. Lines that Radioss reads as optional are not here: the thickness of /PROP/VOID, and what a newer
/// version of the card has behind (Tstart of /INIVEL/TRA since 2025). /SENSOR, /SKEW and /FRAME are judged where a card
/// uses one.
const std::map<Keyword, Lines>& table() {
    static const std::map<Keyword, Lines> lines{
        {Keyword::begin, {"run name", "Invers", "input units", "work units"}},
        {Keyword::unit, {"title", "mass, length and time unit"}},
        {Keyword::part, {"title", "prop_ID mat_ID"}},
        {Keyword::property_shell, {"title", "Ishell ...", "hm hf hr ...", "N, Thick ..."}},
        {Keyword::property_void, {"title"}},
        {Keyword::material_elastic, {"title", "rho", "E nu"}},
        {Keyword::material_johnson_cook, {"title", "rho", "E nu ...", "a b n ...", "c EPS_DOT_0 ...", "m ..."}},
        {Keyword::material_void, {"title", "rho E nu"}},
        {Keyword::material_heat, {"T0 rho_Cp A_S B_S", "T1 A_L B_L EFRAC"}},
        {Keyword::rigid_body, {"title", "node_ID ... grnod_ID", "Jxx Jyy Jzz", "Jxy Jyz Jxz", "Ioptoff Iexpams Ifail"}},
        {Keyword::boundary_condition, {"title", "Tra rot skew_ID grnod_ID"}},
        {Keyword::imposed_velocity, {"title", "fct_IDT Dir ... grnod_ID", "Ascale_x Fscale_y Tstart Tstop"}},
        {Keyword::imposed_displacement, {"title", "fct_IDT Dir ... grnod_ID", "Ascale_x Fscale_y Tstart Tstop"}},
        {Keyword::imposed_temperature, {"title", "fct_IDT sens_ID grnod_ID", "Ascale_x Fscale_y Tstart Tstop"}},
        {Keyword::imposed_acceleration, {"title", "fct_IDT Dir ... grnod_ID", "Ascale_x Fscale_y Tstart Tstop"}},
        {Keyword::initial_translation, {"title", "Vx Vy Vz grnod_ID"}},
        {Keyword::initial_rotation, {"title", "VRx VRy VRz grnod_ID"}},
        {Keyword::initial_axis, {"title", "Dir frame_ID grnod_ID", "Vxt Vyt Vzt Vr"}},
        {Keyword::gravity, {"title", "fct_IDT Dir ... grnod_ID ..."}},
        {Keyword::move_function, {"title", "Ascale_x Fscale_y Ashift_x Fshift_y"}},
        {Keyword::initial_temperature, {"title", "T0 grnod_ID"}},
        {Keyword::added_mass_each, {"title", "Mass grnod_ID"}},
        {Keyword::added_mass_shared, {"title", "Mass grnod_ID"}},
        {Keyword::load, {"title", "fct_IDT Dir ... grnod_ID ..."}},
        {Keyword::function, {"title"}},
        {Keyword::friction, {"title", "Ifric Ifiltr Xfreq", "C1 C2 C3 C4 C5", "C6 Fric VISf"}},
        {Keyword::history_interface, {"title", "variables"}},
        {Keyword::history_node, {"title", "variables"}},
        {Keyword::history_rigid_body, {"title", "variables"}},
    };
    return lines;
}

}  // namespace

const std::vector<std::string_view>& needed_lines(Keyword keyword) {
    static const Lines none;
    const auto found = table().find(keyword);
    return found == table().end() ? none : found->second;
}

}  // namespace type21
