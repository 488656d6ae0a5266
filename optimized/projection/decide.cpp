#include "optimized/projection/decide.h"

#include <limits>
#include <optional>

namespace type21::optimized {

bool Decider::beats(const Contender& one, const Contender& other) const {
    if (one.unsure || other.unsure) return false;
    if (one.kind != other.kind && !rules_.proximity_competes) return one.kind == Kind::contact;
    return one.high < other.low;
}

void Decider::add(SubTriangleId id, const FilterResult& result) {
    if (result.verdict == Verdict::rejected || result.verdict == Verdict::too_far) return;
    const ProjectionResult& projection = result.projection;
    const Contender one{id, projection.kind, result.verdict == Verdict::unsure,
                        projection.kappa - projection.kappa_bound, projection.kappa + projection.kappa_bound};
    bool beaten = false;
    each([&](const Contender& other) { beaten = beaten || beats(other, one); });
    if (beaten) return;
    size_t kept = 0;
    for (size_t i = 0; i < count_; ++i)
        if (!beats(one, list_[i])) list_[kept++] = list_[i];
    count_ = kept;
    std::erase_if(more_, [&](const Contender& other) { return beats(one, other); });
    if (count_ == 0 || id < best_id_) {
        best_ = projection;
        best_id_ = id;
    }
    if (count_ < capacity) {
        list_[count_++] = one;
    } else {
        more_.push_back(one);
    }
}

void Decider::lead(SubTriangleId id, const SegmentData& segment) {
    const bool replaces = leader_.id.exists();
    if (replaces && !leader_.corner.of(id, segment)) return;
    Leader next{id, replaces, leader_.corner};
    if (!replaces && !corner_below(p_, id, segment, next.corner)) return;
    if (replaces) {
        const auto before = [&](const Contender& one) { return one.id == leader_.id; };
        size_t kept = 0;
        for (size_t i = 0; i < count_; ++i)
            if (!before(list_[i])) list_[kept++] = list_[i];
        count_ = kept;
        std::erase_if(more_, before);
    }
    leader_ = next;
}

namespace {

constexpr size_t none_takes_it = std::numeric_limits<size_t>::max();

/// Index of the retained one in double-double; `none_takes_it` where none takes the node; nothing where double-double
/// cannot tell.
std::optional<size_t> first_in_double_double(const V3& p, std::span<const Contender> contenders,
                                             std::span<const SegmentData> segments, const ContactReach& reach,
                                             const ProjectionLimits& rules) {
    size_t first = none_takes_it;
    Kind kind = Kind::none;
    KappaDoubleDouble kappa;
    for (size_t i = 0; i < contenders.size(); ++i) {
        KappaDoubleDouble own;
        const FilterResult result =
            filter_double_double(p, segments[i], contenders[i].id.triangle(), reach, rules, own);
        if (result.verdict == Verdict::rejected || result.verdict == Verdict::too_far) continue;
        if (result.verdict == Verdict::unsure) return std::nullopt;
        bool better = first == none_takes_it;
        if (first != none_takes_it && kind != result.projection.kind && !rules.proximity_competes) {
            better = result.projection.kind == Kind::contact;
        } else if (first != none_takes_it) {
            // The difference rounds once more, relative to itself.
            const double apart = leading(own.value - kappa.value);
            if (!(std::abs(apart) > 1.01 * (own.bound + kappa.bound))) return std::nullopt;
            better = apart < 0;
        }
        if (!better) continue;
        first = i;
        kind = result.projection.kind;
        kappa = own;
    }
    return first;
}

size_t first_in_integers(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
                         const ContactReach& reach, const ProjectionLimits& rules) {
    size_t first = none_takes_it;
    ExactProjection least;
    for (size_t i = 0; i < contenders.size(); ++i) {
        ExactProjection one = project_exact(p, segments[i], contenders[i].id.triangle(), reach, rules);
        if (!one.taken) continue;
        bool better = first == none_takes_it;
        if (!better && one.projection.kind != least.projection.kind && !rules.proximity_competes) {
            better = one.projection.kind == Kind::contact;
        } else if (!better) {
            const int order = compare_kappa(one, least);
            better = order < 0 || (order == 0 && contenders[i].id < contenders[first].id);
        }
        if (!better) continue;
        first = i;
        least = std::move(one);
    }
    return first;
}

/// The magnitudes of the first stage that can tell all of them. So they depend on node and sub-triangle only, and not
/// on the other contenders or on what settled the decision.
ProjectionResult magnitudes(const V3& p, const SegmentData& segment, int triangle, const ContactReach& reach,
                            const ProjectionLimits& rules) {
    const auto good = [](const FilterResult& r) { return r.verdict == Verdict::taken && r.projection.side != 0; };
    const FilterResult fast = filter(p, segment, local_segment(segment), triangle, reach, rules);
    if (good(fast)) return fast.projection;
    KappaDoubleDouble kappa;
    const FilterResult precise = filter_double_double(p, segment, triangle, reach, rules, kappa);
    if (good(precise)) return precise.projection;
    return project_exact(p, segment, triangle, reach, rules).projection;
}

}  // namespace

Retained Decider::settle(std::span<const Contender> contenders, std::span<const SegmentData> segments) const {
    Settled settled = Settled::filter;
    size_t first = 0;
    if (contenders.size() == 1 && !contenders[0].unsure) {
        settled = Settled::double_double;  // only its side is unknown
    } else if (contenders.size() > 1 && tied(p_, contenders, segments, reach_, rules_)) {
        settled = Settled::tie;
        for (size_t i = 1; i < contenders.size(); ++i)
            if (contenders[i].id < contenders[first].id) first = i;
    } else if (const auto found = first_in_double_double(p_, contenders, segments, reach_, rules_)) {
        settled = Settled::double_double;
        first = *found;
    } else {
        settled = Settled::integer;
        first = first_in_integers(p_, contenders, segments, reach_, rules_);
    }
    if (first == none_takes_it) return {};
    if (settled == Settled::tie && best_.side != 0 && contenders[first].id == best_id_)
        return {best_id_, best_, settled};
    const SubTriangleId id = contenders[first].id;
    return {id, magnitudes(p_, segments[first], id.triangle(), reach_, rules_), settled};
}

}  // namespace type21::optimized
