#include "optimized/projection/decide.h"

#include <limits>
#include <optional>

namespace type21::optimized {

bool Decider::beats(const Contender& one, const Contender& other) const {
    if (one.unsure || other.unsure) return false;
    if (one.kind != other.kind && !rules_.proximity_competes) return one.kind == Kind::contact;
    return one.high < other.low;
}

void Decider::add(int rank, int piece, const FilterResult& result) {
    if (result.verdict == Verdict::rejected || result.verdict == Verdict::beyond) return;
    const ProjectionResult& landing = result.landing;
    const Contender one{rank,
                        piece,
                        landing.kind,
                        result.verdict == Verdict::unsure,
                        landing.kappa - landing.kappa_bound,
                        landing.kappa + landing.kappa_bound};
    bool beaten = false;
    each([&](const Contender& other) { beaten = beaten || beats(other, one); });
    if (beaten) return;
    size_t kept = 0;
    for (size_t i = 0; i < count_; ++i)
        if (!beats(one, list_[i])) list_[kept++] = list_[i];
    count_ = kept;
    std::erase_if(more_, [&](const Contender& other) { return beats(one, other); });
    if (count_ == 0 || place(rank, piece) < best_place_) {
        best_ = landing;
        best_place_ = place(rank, piece);
    }
    if (count_ < room) {
        list_[count_++] = one;
    } else {
        more_.push_back(one);
    }
}

void Decider::lead(int rank, const SegmentData& segment, int piece) {
    if (leader_.known && !leader_.corner.of(rank, segment, piece)) return;
    Leader next{true, leader_.known, rank, piece, leader_.corner};
    if (!leader_.known && !corner_below(p_, rank, segment, piece, next.corner)) return;
    if (leader_.known) {
        const auto before = [&](const Contender& one) {
            return one.segment == leader_.segment && one.piece == leader_.piece;
        };
        size_t kept = 0;
        for (size_t i = 0; i < count_; ++i)
            if (!before(list_[i])) list_[kept++] = list_[i];
        count_ = kept;
        std::erase_if(more_, before);
    }
    leader_ = next;
}

namespace {

constexpr size_t nobody = std::numeric_limits<size_t>::max();

bool lower(const Contender& one, const Contender& other) {
    return one.segment != other.segment ? one.segment < other.segment : one.piece < other.piece;
}

/// The place of the retained one in 100 bits, nobody where none takes the node, or nothing where these cannot tell.
std::optional<size_t> first_in_fine(const V3& p, std::span<const Contender> contenders,
                                    std::span<const SegmentData> segments, const ContactReach& window,
                                    const ProjectionLimits& rules) {
    size_t first = nobody;
    Kind kind = Kind::none;
    FineKappa kappa;
    for (size_t i = 0; i < contenders.size(); ++i) {
        FineKappa own;
        const FilterResult result = fine_filter(p, segments[i], contenders[i].piece, window, rules, own);
        if (result.verdict == Verdict::rejected || result.verdict == Verdict::beyond) continue;
        if (result.verdict == Verdict::unsure) return std::nullopt;
        bool better = first == nobody;
        if (first != nobody && kind != result.landing.kind && !rules.proximity_competes) {
            better = result.landing.kind == Kind::contact;
        } else if (first != nobody) {
            // The difference rounds once more, relative to itself.
            const double apart = leading(own.value - kappa.value);
            if (!(std::abs(apart) > 1.01 * (own.bound + kappa.bound))) return std::nullopt;
            better = apart < 0;
        }
        if (!better) continue;
        first = i;
        kind = result.landing.kind;
        kappa = own;
    }
    return first;
}

size_t first_in_whole(const V3& p, std::span<const Contender> contenders, std::span<const SegmentData> segments,
                      const ContactReach& window, const ProjectionLimits& rules) {
    size_t first = nobody;
    ExactLanding least;
    for (size_t i = 0; i < contenders.size(); ++i) {
        ExactLanding one = exact_landing(p, segments[i], contenders[i].piece, window, rules);
        if (!one.taken) continue;
        bool better = first == nobody;
        if (!better && one.landing.kind != least.landing.kind && !rules.proximity_competes) {
            better = one.landing.kind == Kind::contact;
        } else if (!better) {
            const int order = compare_kappa(one, least);
            better = order < 0 || (order == 0 && lower(contenders[i], contenders[first]));
        }
        if (!better) continue;
        first = i;
        least = std::move(one);
    }
    return first;
}

/// Magnitudes are a function of node and sub-triangle alone, whoever the other contenders were and whatever settled the
/// decision: those of the first stage that can tell all of it.
ProjectionResult magnitudes(const V3& p, const SegmentData& segment, int piece, const ContactReach& window,
                            const ProjectionLimits& rules) {
    const auto good = [](const FilterResult& r) { return r.verdict == Verdict::taken && r.landing.side != 0; };
    const FilterResult fast = filter(p, segment, local_segment(segment), piece, window, rules);
    if (good(fast)) return fast.landing;
    FineKappa kappa;
    const FilterResult fine = fine_filter(p, segment, piece, window, rules, kappa);
    if (good(fine)) return fine.landing;
    return exact_landing(p, segment, piece, window, rules).landing;
}

}  // namespace

Retained Decider::settle(std::span<const Contender> contenders, std::span<const SegmentData> segments) const {
    Settled settled = Settled::filter;
    size_t first = 0;
    if (contenders.size() == 1 && !contenders[0].unsure) {
        settled = Settled::fine;  // only its side is open
    } else if (contenders.size() > 1 && tied(p_, contenders, segments, window_, rules_)) {
        settled = Settled::tie;
        for (size_t i = 1; i < contenders.size(); ++i)
            if (lower(contenders[i], contenders[first])) first = i;
    } else if (const auto fine = first_in_fine(p_, contenders, segments, window_, rules_)) {
        settled = Settled::fine;
        first = *fine;
    } else {
        settled = Settled::whole;
        first = first_in_whole(p_, contenders, segments, window_, rules_);
    }
    if (first == nobody) return {};
    if (settled == Settled::tie && best_.side != 0 &&
        place(contenders[first].segment, contenders[first].piece) == best_place_)
        return {contenders[first].segment, contenders[first].piece, best_, settled};
    return {contenders[first].segment, contenders[first].piece,
            magnitudes(p_, segments[first], contenders[first].piece, window_, rules_), settled};
}

}  // namespace type21::optimized
