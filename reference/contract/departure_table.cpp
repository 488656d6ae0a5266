/// @file The table of departures and the names of a set of them.
#include "departures.h"

namespace type21 {
namespace {

constexpr std::string_view not_reproduced =
    "not reproduced: the measured result depends on undefined memory, on other parts of the model, or on chance";

std::vector<DepartureRow> make_table() {
    using enum Departure;
    const auto yes = [](Departure id, std::string_view documented, std::string_view built) {
        return DepartureRow{id, documented, built, true, ""};
    };
    const auto no = [](Departure id, std::string_view documented, std::string_view built, std::string_view reason) {
        return DepartureRow{id, documented, built, false, reason};
    };
    return {
        yes(D01, "Stmin and Stmax bound the nodal stiffness", "Stmin and Stmax are read and never applied"),
        yes(D02, "Istf 1: Stfac 0 means no stiffness", "Istf 1: Stfac 0 means 1 in deck units"),
        yes(D03, "DEPTH is read for every Igap", "DEPTH of the card is ignored for Igap 0"),
        yes(D04, "the friction increment and the divisor of the slip energy use k",
            "they use S without Stfac; Istf 1: 1 in deck units"),
        yes(D05, "elastic energy is half k p squared for Istf 1 too",
            "Istf 1 with Igap 0 or 1: Stfac raised to the power p squared for each node with stiffness"),
        yes(D06, "Ifiltr 3: the filter factor is the smaller of 1 and 2 pi f dt", "the larger of the two"),
        yes(D07, "Ifiltr 2: the filter factor is 2 pi Xfreq, Xfreq between 0 and 1",
            "2 pi / Xfreq, an error below 2 pi"),
        yes(D08, "fct_IDF is taken at AscaleF times the mean temperature",
            "AscaleF is unused and the main side has Tint"),
        yes(D09, "sens_ID replaces Tstart and Tstop", "the sensor is ignored, Tstart and Tstop stay"),
        yes(D10, "Ifric 4 decays from Fric to C1", "the sign is reversed: 2 C1 - Fric at rest"),
        yes(D11, "contact comes before proximity, proximity gives no force",
            "both compete in one selection; a proximity may give a node near the tool a force"),
        yes(D12, "the contact normal is the interpolated normal",
            "it is the direction from the contact point to the node, which is noise near the surface"),
        yes(D13, "tool damping uses the sum of k", "tool damping uses the sum of k + C/dt"),
        yes(D14, "Fcond without Dcond: Dcond is Drad", "Dcond stays 0"),
        yes(D15, "radiation while the distance is at most Drad", "while the distance less the gap is at most Drad"),
        yes(D16, "friction heat goes to the secondary side", "Ithe_form 1: in full to the tool as well"),
        yes(D17, "the conditions on C1..C6 of the Renard law are checked", "they are not checked"),
        yes(D18, "a node on both sides is an error", "it is accepted"),
        yes(D19, "Gapmin default: half of the mean thickness of the secondary shells",
            "half of the mean over the secondary nodes of the thickest shell at each"),
        yes(D20, "Inacti 3 moves the node out; 2 and 4 are errors", "2, 3 and 4 give a message and act as 0"),
        no(D21, "Ifric 1 to 4 of the card use C1..C6", "the coefficients are read from the wrong place in memory",
           not_reproduced),
        no(D22, "nodal areas are computed once over the surface's own elements",
           "a solid in a thermal model sets them to 0, a repeated sort multiplies them", not_reproduced),
        no(D23, "the search covers every point of a turning tool from the first cycle on",
           "its margin is that of one node, and the first search may be skipped; contacts are missed", not_reproduced),
        yes(D24, "tool orientation and position are of the same time", "the orientation is one step older"),
        yes(D25, "the friction increment uses the last step, impulses the mean of the last and the next step",
            "friction increment and contact impulses use the mean step of the previous cycle"),
        yes(D26, "Inacti 6 applies to every impact", "Inacti 6 acts as 0 when nothing penetrates at time 0"),
        no(D27, "Igap other than 0, 1, 2 is an error", "it is accepted; the result follows no known rule",
           not_reproduced),
        yes(D28, "/FRICTION filters with its own Xfreq", "the filter factor is that of the interface card"),
        yes(D29, "contact thickness of a node: the largest of its parts",
            "each corner is compared with one of the four nodes of lowest id; mostly the last segment decides"),
        yes(D30, "Igap 2: the gap follows the current thickness, then Gapmin and Gapmax bound it",
            "the bounded gap of time 0 plus the change of thickness, bounded again"),
        yes(D31, "the first penetration comes from the projection of every cycle",
            "from another projection at time 0 with wider margins"),
        yes(D32, "Fcond scales the exchange coefficient, in series with the sheet", "it scales the whole conductance"),
        yes(D33, "a node's own gap decides contact",
            "the larger of its gap and the largest gap of the interface decides"),
        yes(D34, "every segment competes for a node",
            "only segments whose box along their normals contains the node; contacts are "
            "lost over narrow convex strips"),
        yes(D35, "a nodal normal that does not face outward rejects the sub-triangle",
            "a tiny number replaces its slope, and the sub-triangle is often accepted"),
        yes(D36, "Kthe 0 with fct_IDK means no conduction", "it means 1"),
        yes(D37, "an element is to be divided where the tool radius is below NRadm times its longest edge",
            "below sqrt(2) times that"),
        yes(D38, "fct_IDK is taken at the pressure over AscaleK",
            "it is taken at AscaleK times the pressure, and Kthe is the number as written in any units"),
        yes(D39, "Ifric 0 with fct_IDF: the coefficient is at least 0",
            "it is not bounded, and a negative one drives the sliding"),
        yes(D40, "Dampr uses the inertia about the axis of the rotation", "it uses the smallest principal inertia"),
        yes(D41, "a segment that a surface holds twice counts once in its areas and normals", "it counts twice"),
        yes(D42, "/FRICTION: a node has the part of its first segment in the secondary surface",
            "it has, of its parts in the pairs of /FRICTION, the last one of the deck"),
        yes(D43, "Ifric 2 and 4: a term with the coefficient 0 is 0",
            "where its exponential overflows the friction coefficient drops to 1e-30"),
        no(D44, "the columns of the time history are the same on any number of domains",
           "the sums of absolute values are wrong on more than one domain",
           "not reproduced: a run here has one domain, and its sums are the same for any number of threads"),
    };
}

}  // namespace

const std::vector<DepartureRow>& departures() {
    static const std::vector<DepartureRow> table = make_table();
    return table;
}

std::string name(Departure departure) {
    const int number = static_cast<int>(departure);
    return (number < 10 ? "D0" : "D") + std::to_string(number);
}

AsBuilt AsBuilt::all() {
    AsBuilt set;
    for (const DepartureRow& row : departures())
        if (row.available) set.set(row.id);
    return set;
}

std::string AsBuilt::text() const {
    std::string out;
    for (const DepartureRow& row : departures())
        if (has(row.id)) out += (out.empty() ? "" : ", ") + name(row.id);
    return out.empty() ? "none" : out;
}

}  // namespace type21
