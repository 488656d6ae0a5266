#include "optimized/decide/decide.h"

namespace type21::optimized {

bool Decider::beats(const Contender& one, const Contender& other) const {
    if (one.unsure || other.unsure) return false;
    if (one.kind != other.kind && !rules_.one_race) return one.kind == Kind::contact;
    return one.high < other.low;
}

void Decider::add(int rank, int piece, const FilterResult& result) {
    if (result.verdict == Verdict::rejected || result.verdict == Verdict::beyond) return;
    const Landing& landing = result.landing;
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
    if (count_ == 0) best_ = landing;
    if (count_ < room) {
        list_[count_++] = one;
    } else {
        more_.push_back(one);
    }
}

Retained Decider::settle(const std::vector<SegmentData>& segments) const {
    // Exact numbers for each contender, then the order of section 4.
    struct Known {
        ExactLanding landing;
        int segment, piece;
    };
    std::vector<Known> known;
    size_t at = 0;
    each([&](const Contender& one) {
        Known k{exact_landing(p_, segments[at++], one.piece, window_, rules_), one.segment, one.piece};
        if (k.landing.taken) known.push_back(std::move(k));
    });
    const auto precedes = [&](const Known& one, const Known& other) {
        if (one.landing.landing.kind != other.landing.landing.kind && !rules_.one_race)
            return one.landing.landing.kind == Kind::contact;
        const int order = compare_kappa(one.landing, other.landing);
        if (order != 0) return order < 0;
        if (one.segment != other.segment) return one.segment < other.segment;
        return one.piece < other.piece;
    };
    const auto first = std::min_element(known.begin(), known.end(), precedes);
    if (first == known.end()) return {};
    return {first->segment, first->piece, first->landing.landing, Settled::whole};
}

}  // namespace type21::optimized
