#include <cmath>

#include <fmt/format.h>

#include "reference/model/reading.h"

namespace type21 {

namespace {

void check_elasticity(CardReader& reader, size_t line, const Material& material) {
    const bool is_void = material.law == MaterialLaw::none;
    if (material.density < 0 || (!is_void && material.density == 0)) {
        reader.error(1, "rho", quantity(reader, material.density, dim::density), "the density is positive",
                     "Give the density in the units of the deck");
    }
    if (material.young < 0 || (!is_void && material.young == 0)) {
        reader.error(static_cast<int>(line), "E", quantity(reader, material.young, dim::pressure),
                     "Young's modulus is positive", "Give the modulus in the units of the deck");
    }
    if (material.poisson < -1 || material.poisson >= 0.5) {
        reader.error(static_cast<int>(line), "nu", fmt::format("{}", material.poisson),
                     "Poisson's ratio is at least -1 and below 0.5", "Give a ratio such as 0.3");
    }
}

/// Ludwik's a, b, n from yield stress and the engineering stress and strain at the highest load (Iflag 1): there the
/// true stress a + b e^n equals its own slope (Considere), with e = ln(1 + eUTS) and s = UTS (1 + eUTS).
void from_tensile_test(CardReader& reader, std::array<double, 5>& plastic) {
    const double yield = plastic[0];
    const double stress = plastic[1] * (1 + plastic[2]);
    const double strain = std::log1p(plastic[2]);
    if (!(yield > 0) || !(strain > 0) || !(stress > yield)) {
        reader.error(3, "UTS", quantity(reader, plastic[1], dim::pressure),
                     "with Iflag 1, sig_y and eUTS are positive and UTS (1 + eUTS) is above sig_y",
                     "Give the values of a tensile test, or a, b, n with Iflag 0");
        return;
    }
    plastic[2] = stress * strain / (stress - yield);
    plastic[1] = stress / (plastic[2] * std::pow(strain, plastic[2] - 1));
}

/// The rate and heat terms (c, m, ...) act only in element forces, which are not computed.
void read_plasticity(CardReader& reader, Material& material) {
    const Id iflag = reader.integer(2, 41, 50, "Iflag");
    const bool tensile = iflag == 1;
    reader.unused(2, 51, 60, 10);  // VP
    reader.unused(2, 61, 80, 20);  // Pmin
    reader.unused(4, 1, 40, 20);   // c, EPS_DOT_0
    reader.unused(4, 41, 60, 10);  // ICC, Fsmooth
    reader.unused(4, 61, 100, 20);
    reader.unused(5, 1, 100, 20);  // m, Tmelt, rho_Cp, Tr, Tmax
    auto& p = material.plastic;
    p[0] = reader.real(3, 1, 20, tensile ? "sig_y" : "a", dim::pressure);
    p[1] = reader.real(3, 21, 40, tensile ? "UTS" : "b", dim::pressure);
    p[2] = reader.real(3, 41, 60, tensile ? "eUTS" : "n", dim::none);
    p[3] = reader.real(3, 61, 80, "EPS_p_max", dim::none);
    p[4] = reader.real(3, 81, 100, "SIG_max0", dim::pressure);
    if (p[3] == 0) p[3] = 1e30;
    if (p[4] == 0) p[4] = 1e30;
    if (tensile) {
        from_tensile_test(reader, p);
    } else if (iflag != 0) {
        reader.error(2, "Iflag", fmt::format("{}", iflag), "Iflag is 0 or 1", "Choose 0 (a, b, n) or 1 (tensile test)");
    }
}

void read_law(Reading& reading, Keyword keyword, MaterialLaw law) {
    std::vector<Material>& materials = reading.model.materials;
    const auto next = [&] { return static_cast<int>(materials.size()); };
    reading.each(keyword, reading.materials, next, [&](CardReader& reader, Id id) {
        Material material;
        material.id = id;
        material.title = reader.text(0, 1, 100);
        material.law = law;
        material.density = reader.real(1, 1, 20, "rho", dim::density);
        if (law != MaterialLaw::none) reader.unused(1, 21, 40, 20);  // reference density, for solids
        const bool is_void = law == MaterialLaw::none;               // its one line holds all three
        const size_t line = is_void ? 1 : 2;
        const int first = is_void ? 21 : 1;
        material.young = reader.real(line, first, first + 19, "E", dim::pressure);
        material.poisson = reader.real(line, first + 20, first + 39, "nu", dim::none);
        check_elasticity(reader, line, material);
        if (law == MaterialLaw::johnson_cook) read_plasticity(reader, material);
        warn_of_excess(reader, is_void ? 2 : law == MaterialLaw::elastic ? 3 : 6);
        materials.push_back(std::move(material));
    });
}

void read_properties(Reading& reading) {
    std::vector<Property>& properties = reading.model.properties;
    const auto next = [&] { return static_cast<int>(properties.size()); };
    reading.each(Keyword::property_shell, reading.properties, next, [&](CardReader& reader, Id id) {
        Property property;
        property.id = id;
        property.title = reader.text(0, 1, 100);
        reader.unused(1, 1, 60, 10);  // Ishell, Ismstr, Ish3n, Idrill, Ipinch
        reader.unused(1, 61, 100, 20);
        reader.unused(2, 1, 100, 20);  // hm, hf, hr, dm, dn
        reader.unused(3, 11, 20, 10);  // Istrain
        reader.unused(3, 41, 60, 20);  // Ashear
        reader.unused(3, 61, 70, 10);
        reader.unused(3, 81, 100, 10);  // Iplas, Ipos
        property.integration_points = static_cast<int>(reader.integer(3, 1, 10, "N"));
        property.thickness = reader.real(3, 21, 40, "Thick", dim::length);
        property.thickness_change = static_cast<int>(reader.integer(3, 71, 80, "Ithick"));
        if (property.thickness < 0) {
            reader.error(3, "Thick", quantity(reader, property.thickness, dim::length), "a thickness is not negative",
                         "Give the thickness of the shells");
        }
        warn_of_excess(reader, 4);
        properties.push_back(std::move(property));
    });
    reading.each(Keyword::property_void, reading.properties, next, [&](CardReader& reader, Id id) {
        Property property;
        property.id = id;
        property.title = reader.text(0, 1, 100);
        property.kind = PropertyKind::none;
        property.thickness = reader.real(1, 1, 20, "Thick", dim::length);
        properties.push_back(std::move(property));
    });
}

void read_parts(Reading& reading) {
    std::vector<Part>& parts = reading.model.parts;
    const auto next = [&] { return static_cast<int>(parts.size()); };
    reading.each(Keyword::part, reading.parts, next, [&](CardReader& reader, Id id) {
        Part part;
        part.id = id;
        part.title = reader.text(0, 1, 100);
        part.property = reading.reference(reader, 1, 1, 10, "prop_ID", reading.properties, true);
        part.material = reading.reference(reader, 1, 11, 20, "mat_ID", reading.materials, true);
        part.contact_thickness = reader.real(1, 31, 50, "Thick", dim::length);
        if (part.contact_thickness < 0) {
            reader.error(1, "Thick", quantity(reader, part.contact_thickness, dim::length),
                         "a contact thickness is not negative", "Give 0 for that of the shells");
        }
        reading.part_subsets.push_back(reader.integer(1, 21, 30, "subset_ID"));
        warn_of_excess(reader, 2);
        parts.push_back(std::move(part));
    });
}

}  // namespace

/// /MAT, /PROP and /PART.
void read_materials(Reading& reading) {
    read_law(reading, Keyword::material_elastic, MaterialLaw::elastic);
    read_law(reading, Keyword::material_johnson_cook, MaterialLaw::johnson_cook);
    read_law(reading, Keyword::material_void, MaterialLaw::none);
    read_properties(reading);
    read_parts(reading);
}

}  // namespace type21
