#include "reference/model/known_keywords.h"

#include <algorithm>
#include <map>

namespace type21 {

namespace {

const std::map<std::string, Keyword, std::less<>>& known_keywords() {
    static const std::map<std::string, Keyword, std::less<>> table{
        {"BEGIN", Keyword::begin},
        {"UNIT", Keyword::unit},
        {"TITLE", Keyword::title},
        {"NODE", Keyword::node},
        {"SHELL", Keyword::shell},
        {"SH3N", Keyword::sh3n},
        {"PART", Keyword::part},
        {"PROP/SHELL", Keyword::property_shell},
        {"PROP/TYPE1", Keyword::property_shell},
        {"PROP/VOID", Keyword::property_void},
        {"PROP/TYPE0", Keyword::property_void},
        {"MAT/ELAST", Keyword::material_elastic},
        {"MAT/LAW1", Keyword::material_elastic},
        {"MAT/PLAS_JOHNS", Keyword::material_johnson_cook},
        {"MAT/LAW2", Keyword::material_johnson_cook},
        {"MAT/VOID", Keyword::material_void},
        {"MAT/LAW0", Keyword::material_void},
        {"HEAT/MAT", Keyword::material_heat},
        {"SURF/PART", Keyword::surface_part},
        {"SURF/PART/EXT", Keyword::surface_part},
        {"SURF/PART/ALL", Keyword::surface_part},
        {"SURF/SEG", Keyword::surface_segment},
        {"SURF/SURF", Keyword::surface_surface},
        {"GRNOD/NODE", Keyword::group_node},
        {"GRNOD/PART", Keyword::group_part},
        {"GRNOD/SURF", Keyword::group_surface},
        {"GRNOD/GRNOD", Keyword::group_group},
        {"RBODY", Keyword::rigid_body},
        {"RBODY/LAGMUL", Keyword::unsupported},
        {"BCS", Keyword::boundary_condition},
        {"BCS/LAGMUL", Keyword::unsupported},
        {"BCS/CYCLIC", Keyword::unsupported},
        {"BCS/WALL", Keyword::unsupported},
        {"BCS/NRF", Keyword::unsupported},
        {"IMPVEL", Keyword::imposed_velocity},
        {"IMPVEL/FGEO", Keyword::unsupported},
        {"IMPVEL/LAGMUL", Keyword::unsupported},
        {"IMPDISP", Keyword::imposed_displacement},
        {"IMPDISP/FGEO", Keyword::unsupported},
        {"INIVEL/TRA", Keyword::initial_velocity},
        {"ADMAS/0", Keyword::added_mass_each},
        {"ADMAS/1", Keyword::added_mass_shared},
        {"INITEMP", Keyword::initial_temperature},
        {"IMPTEMP", Keyword::imposed_temperature},
        {"CLOAD", Keyword::load},
        {"FUNCT", Keyword::function},
        {"SENSOR/TIME", Keyword::sensor},
        {"FRICTION", Keyword::friction},
        {"FRICTION/ORIENTATION", Keyword::unsupported},
        {"INTER/TYPE21", Keyword::interface},
        {"TH/INTER", Keyword::history_interface},
        {"TH/NODE", Keyword::history_node},
        {"TH/RBODY", Keyword::history_rigid_body},
        {"TH", Keyword::output},
        {"ANIM", Keyword::output},
        {"H3D", Keyword::output},
        {"STATE", Keyword::output},
        {"OUTP", Keyword::output},
        // Element formulations: no element force is computed, so their defaults change nothing here.
        {"DEF_SHELL", Keyword::output},
        {"DEF_SOLID", Keyword::output},
        {"ANALY", Keyword::analysis},
        // Names and numbers of others: what refers to a skew, a frame or a subset is checked where it does.
        {"SUBSET", Keyword::harmless},
        {"SKEW", Keyword::harmless},
        {"FRAME", Keyword::harmless},
        {"IOFLAG", Keyword::harmless},
        {"SPMD", Keyword::harmless},
        {"KEY", Keyword::harmless},
    };
    return table;
}

bool is_number(const std::string& word) {
    return std::all_of(word.begin(), word.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

KeywordMatch match(const Card& card) {
    for (std::size_t words = std::min<std::size_t>(3, card.words.size()); words > 0; --words) {
        std::string key = card.words[0];
        for (std::size_t i = 1; i < words; ++i)
            key += "/" + card.words[i];
        if (const auto found = known_keywords().find(key); found != known_keywords().end())
            return {found->second, words};
    }
    return {Keyword::unsupported, 1};
}

std::string keyword_without_ids(const Card& card) {
    std::string text;
    for (std::size_t i = 0; i < card.words.size(); ++i) {
        if (i == 0 || !is_number(card.words[i])) text += "/" + card.words[i];
    }
    return text.empty() ? "/" : text;
}

}  // namespace type21
