#include "verification/performance/accuracy/effect_cost.h"

namespace type21::accuracy {

namespace {

void nothing(Interface&) {}

void coulomb(Interface& card) {
    card.fric.value = 0.1;
}

void law_coefficients(Interface& card) {
    const double c[6]{0.05, 1e-6, 1e-3, 1e-6, 1e-3, 0.1};
    for (size_t i = 0; i < 6; ++i)
        card.c[i].value = c[i];
}

void growing_gap(Interface& card) {
    card.igap.value = 2;
}

void heat_fields(Interface& card) {
    card.kthe.value = 1;
    card.tint.value = 500;
    card.frad.value = 1e-9;
    card.drad.value = 1.5;
}

}  // namespace

const std::vector<EffectCard>& effect_cards() {
    static const std::vector<EffectCard> cards{
        {"contact damping (VISs)", "VISs 0", true, nothing, nothing, [](Interface& card) { card.viss.value = 0.5; }},
        {"Coulomb friction (Fric)", "Fric 0, with Xfreq and C1 to C6 given", true, nothing,
         [](Interface& card) {
             law_coefficients(card);
             card.xfreq.value = 0.1;
         },
         coulomb},
        {"friction law (Ifric 1)", "Ifric 0, with C1 to C6 given", true, coulomb, law_coefficients,
         [](Interface& card) { card.ifric.value = 1; }},
        {"friction law (Ifric 2)", "Ifric 0, with C1 to C6 given", true, coulomb, law_coefficients,
         [](Interface& card) { card.ifric.value = 2; }},
        {"filter of friction (Ifiltr 1)", "Ifiltr 0, with Xfreq given", true, coulomb,
         [](Interface& card) { card.xfreq.value = 0.1; }, [](Interface& card) { card.ifiltr.value = 1; }},
        {"gap that follows the thickness (Igap 2)", "Igap 0, with Fscalegap given", true, nothing,
         [](Interface& card) { card.fscalegap.value = 1; }, growing_gap},
        {"pressure limit (Pmax)", "Pmax 1e30, with ITlim given", true, growing_gap,
         [](Interface& card) { card.itlim.value = 1; }, [](Interface& card) { card.pmax.value = 10; }},
        {"skid line (Pskid)", "Pskid 1e30", false, coulomb, nothing, [](Interface& card) { card.pskid.value = 1; }},
        {"heat exchange (Ithe 1)", "Ithe 0, with Kthe, Tint, Frad and Drad given", false, nothing, heat_fields,
         [](Interface& card) { card.ithe.value = 1; }},
        {"friction heat (Fheat)", "Fheat 0", false,
         [](Interface& card) {
             coulomb(card);
             heat_fields(card);
             card.ithe.value = 1;
         },
         nothing, [](Interface& card) { card.fheat.value = 1; }},
        {"test of the normals (Invn 1)", "Invn 0", false, nothing, nothing,
         [](Interface& card) { card.invn.value = 1; }},
        {"tool damping (Damp)", "Damp 0", true, nothing, nothing, [](Interface& card) { card.damp.value = 0.1; }},
        {"initial offset (Inacti 6)", "Inacti 0", true, nothing, nothing,
         [](Interface& card) { card.inacti.value = 6; }},
        {"window of time (Tstart)", "Tstart 0, Tstop 1e30", true, nothing, nothing,
         [](Interface& card) { card.tstart.value = 1e-20; }},
    };
    return cards;
}

}  // namespace type21::accuracy
