#include "reference/exact/impact_enclosure.h"
#include "reference/exact/interval.h"

namespace type21::reference {

std::optional<ImpactEnclosure> enclosed_by_interval(const ContactQuery& query, const SegmentShape<double>& shape,
                                                    int segment, int k) {
    try {
        const Interval::Upward upward;
        const auto impact = impact_in<Interval>(query, shape, segment, k);
        return enclosure_of(impact, impact.kappa.low(), impact.kappa.high());
    } catch (const Undecided&) {
        return std::nullopt;
    }
}

}  // namespace type21::reference
