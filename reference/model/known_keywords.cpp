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
        {"SURF", Keyword::selection},
        {"GRNOD", Keyword::selection},
        {"GRSHEL", Keyword::selection},
        {"GRSH3N", Keyword::selection},
        {"GRPART", Keyword::selection},
        {"BOX", Keyword::selection},
        {"SUBSET", Keyword::selection},
        {"SET", Keyword::selection},
        {"TRANSFORM/TRA", Keyword::transform},
        {"TRANSFORM/ROT", Keyword::transform},
        {"TRANSFORM/SYM", Keyword::transform},
        {"TRANSFORM/SCA", Keyword::transform},
        {"TRANSFORM/MATRIX", Keyword::transform},
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
        {"IMPACC", Keyword::imposed_acceleration},
        {"IMPACC/LAGMUL", Keyword::unsupported},
        {"INIVEL/TRA", Keyword::initial_translation},
        {"INIVEL/ROT", Keyword::initial_rotation},
        {"INIVEL/AXIS", Keyword::initial_axis},
        {"GRAV", Keyword::gravity},
        {"ADMAS/0", Keyword::added_mass_each},
        {"ADMAS/1", Keyword::added_mass_shared},
        {"INITEMP", Keyword::initial_temperature},
        {"IMPTEMP", Keyword::imposed_temperature},
        {"CLOAD", Keyword::load},
        {"FUNCT", Keyword::function},
        {"MOVE_FUNCT", Keyword::move_function},
        // Of whatever kind: one that nothing uses does no harm.
        {"SENSOR", Keyword::sensor},
        {"FRICTION", Keyword::friction},
        {"FRICTION/ORIENTATION", Keyword::unsupported},
        {"INTER/TYPE21", Keyword::interface},
        {"TH/INTER", Keyword::history_interface},
        {"TH/NODE", Keyword::history_node},
        {"TH/RBODY", Keyword::history_rigid_body},
        // Output that is not written.
        {"TH", Keyword::output},
        {"ATH", Keyword::output},
        {"BTH", Keyword::output},
        {"CTH", Keyword::output},
        {"DTH", Keyword::output},
        {"ETH", Keyword::output},
        {"FTH", Keyword::output},
        {"GTH", Keyword::output},
        {"HTH", Keyword::output},
        {"ITH", Keyword::output},
        {"THPART", Keyword::output},
        {"ACCEL", Keyword::output},
        {"GAUGE", Keyword::output},
        {"SECT", Keyword::output},
        {"ANIM", Keyword::output},
        {"H3D", Keyword::output},
        {"STATE", Keyword::output},
        {"OUTP", Keyword::output},
        {"DYNAIN", Keyword::output},
        {"INTER/SUB", Keyword::output},
        // Element formulations: no element force is computed, so their defaults change nothing here.
        {"SHFRA", Keyword::output},
        {"DEF_SHELL", Keyword::output},
        {"DEF_SOLID", Keyword::output},
        {"ANALY", Keyword::analysis},
        {"RANDOM", Keyword::random},
        // Listings, memory, processors, names.
        {"IOFLAG", Keyword::harmless},
        {"SPMD", Keyword::harmless},
        {"MEMORY", Keyword::harmless},
        {"CHECKSUM", Keyword::harmless},
        {"KEY", Keyword::harmless},
        {"VERS", Keyword::harmless},
        {"RUNNAME", Keyword::harmless},
        {"ARCH", Keyword::harmless},
        {"REPORT", Keyword::harmless},
        {"SUBDOMAIN", Keyword::harmless},
        // Names and numbers for others: what refers to one that is not read is checked where it does.
        {"GRBRIC", Keyword::definition},
        {"GRQUAD", Keyword::definition},
        {"GRTRIA", Keyword::definition},
        {"GRBEAM", Keyword::definition},
        {"GRTRUS", Keyword::definition},
        {"GRSPRI", Keyword::definition},
        {"LINE", Keyword::definition},
        {"SKEW", Keyword::definition},
        {"SKEW/FIX", Keyword::skew_fixed},
        {"FRAME", Keyword::definition},
        {"FRAME/FIX", Keyword::frame_fixed},
        {"FUNCT_SMOOTH", Keyword::definition},
        {"FUNC_2D", Keyword::definition},
        {"TABLE", Keyword::definition},
        // Elements and what acts on them.
        {"MAT", Keyword::element},
        {"PROP", Keyword::element},
        {"EOS", Keyword::element},
        {"FAIL", Keyword::element},
        {"VISC", Keyword::element},
        {"THERM_STRESS", Keyword::element},
        {"NONLOCAL", Keyword::element},
        {"LEAK", Keyword::element},
        {"BRICK", Keyword::element},
        {"BRIC20", Keyword::element},
        {"TETRA4", Keyword::element},
        {"TETRA10", Keyword::element},
        {"PENTA6", Keyword::element},
        {"SHEL16", Keyword::element},
        {"QUAD", Keyword::element},
        {"TRIA", Keyword::element},
        {"BEAM", Keyword::element},
        {"TRUSS", Keyword::element},
        {"SPRING", Keyword::element},
        {"XELEM", Keyword::element},
        {"SPHCEL", Keyword::element},
        {"SPHGLO", Keyword::element},
        {"SPHBCS", Keyword::element},
        {"PLOAD", Keyword::element},
        {"LOAD", Keyword::element},
        {"INISHE", Keyword::element},
        {"INISH3", Keyword::element},
        {"INISH4", Keyword::element},
        {"INIBRI", Keyword::element},
        {"INIQUA", Keyword::element},
        {"INITRUSS", Keyword::element},
        {"INIBEAM", Keyword::element},
        {"INISPRI", Keyword::element},
        {"INISTA", Keyword::element},
        {"INICRACK", Keyword::element},
        {"INIVOL", Keyword::element},
        {"EREF", Keyword::element},
        {"XREF", Keyword::element},
        {"REFSTA", Keyword::element},
        {"DRAPE", Keyword::element},
        {"STACK", Keyword::element},
        {"PLY", Keyword::element},
        {"ADMESH", Keyword::element},
        {"PERTURB", Keyword::element},
        {"INTER", Keyword::other_interface},
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
