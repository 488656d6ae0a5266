#include "reference/exact/fraction.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <CGAL/Gmpq.h>

namespace type21::reference {

namespace {

/// 1/d where d is a power of two whose inverse is a double too; 0 otherwise. Such a divisor needs no factor.
double exact_inverse(const Fraction::Integer& divisor) {
    const double value = CGAL::to_double(divisor);
    int exponent = 0;
    if (!std::isfinite(value) || std::abs(std::frexp(value, &exponent)) != 0.5 || std::abs(exponent) > 1000) return 0;
    return Fraction::Integer(value) == divisor ? 1.0 / value : 0;
}

}  // namespace

int Fraction::sign() const {
    int sign = static_cast<int>(CGAL::sign(integer_));
    for (const Power& power : powers_)
        if (power.exponent % 2 != 0 && CGAL::sign(power.factor->value) < 0) sign = -sign;
    return sign;
}

double Fraction::to_double() const {
    const auto [low, high] = enclosure();
    return low + 0.5 * (high - low);
}

std::pair<double, double> Fraction::enclosure() const {
    const Powers above = merge(powers_, {}, [](int i, int) { return std::max(i, 0); });
    const Powers below = merge(powers_, {}, [](int i, int) { return std::max(-i, 0); });
    return CGAL::to_interval(CGAL::Gmpq(multiplied(integer_, above)) / CGAL::Gmpq(multiplied(1, below)));
}

template <class Combine>
Fraction::Powers Fraction::merge(const Powers& a, const Powers& b, Combine combine) {
    Powers merged;
    merged.reserve(a.size() + b.size());
    const auto add = [&](const Power& power, int exponent) {
        if (exponent != 0) merged.push_back({power.factor, exponent});
    };
    auto i = a.begin();
    auto j = b.begin();
    while (i != a.end() || j != b.end()) {
        if (j == b.end() || (i != a.end() && i->factor->rank < j->factor->rank)) {
            add(*i, combine(i->exponent, 0));
            ++i;
        } else if (i == a.end() || j->factor->rank < i->factor->rank) {
            add(*j, combine(0, j->exponent));
            ++j;
        } else {
            add(*i, combine(i->exponent, j->exponent));
            ++i;
            ++j;
        }
    }
    return merged;
}

Fraction::Integer Fraction::multiplied(Integer integer, const Powers& powers) {
    for (const Power& power : powers)
        for (int i = 0; i < power.exponent; ++i)
            integer = integer * power.factor->value;
    return integer;
}

const std::shared_ptr<const Fraction::Factor>& Fraction::as_factor() const {
    static thread_local long made = 0;
    if (!as_factor_) as_factor_ = std::make_shared<const Factor>(Factor{integer_, made++});
    return as_factor_;
}

Fraction Fraction::sum(const Fraction& a, const Fraction& b, int sign) {
    if (CGAL::sign(b.integer_) == CGAL::ZERO) return a;
    if (CGAL::sign(a.integer_) == CGAL::ZERO) return sign > 0 ? b : -b;
    const auto beyond = [](int i, int j) { return i - std::min(i, j); };
    const Integer left = multiplied(a.integer_, merge(a.powers_, b.powers_, beyond));
    const Integer right = multiplied(b.integer_, merge(b.powers_, a.powers_, beyond));
    Fraction result;
    result.integer_ = sign > 0 ? left + right : left - right;
    if (CGAL::sign(result.integer_) != CGAL::ZERO)
        result.powers_ = merge(a.powers_, b.powers_, [](int i, int j) { return std::min(i, j); });
    return result;
}

Fraction operator*(const Fraction& a, const Fraction& b) {
    Fraction result;
    if (CGAL::sign(a.integer_) == CGAL::ZERO || CGAL::sign(b.integer_) == CGAL::ZERO) return result;
    result.integer_ = a.integer_ * b.integer_;
    result.powers_ = Fraction::merge(a.powers_, b.powers_, [](int i, int j) { return i + j; });
    return result;
}

Fraction operator/(const Fraction& a, const Fraction& b) {
    if (CGAL::sign(b.integer_) == CGAL::ZERO) throw std::domain_error("division of an exact number by zero");
    Fraction result;
    if (CGAL::sign(a.integer_) == CGAL::ZERO) return result;
    const auto less = [](int i, int j) { return i - j; };
    result.integer_ = a.integer_;
    result.powers_ = Fraction::merge(a.powers_, b.powers_, less);
    if (const double inverse = exact_inverse(b.integer_); inverse != 0) {
        result.integer_ = result.integer_ * Fraction::Integer(inverse);
    } else {
        result.powers_ = Fraction::merge(result.powers_, {{b.as_factor(), 1}}, less);
    }
    return result;
}

Fraction operator-(const Fraction& a) {
    Fraction negative = a;
    negative.integer_ = -a.integer_;
    negative.as_factor_ = nullptr;
    return negative;
}

}  // namespace type21::reference
