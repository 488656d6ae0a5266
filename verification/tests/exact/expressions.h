/// @file Random expressions, computed in several numbers at once.
#pragma once

#include <cmath>
#include <random>
#include <vector>

namespace type21::reference {

/// A straight-line program over + - * /: the same operations on the same doubles for every number type.
class Expression {
  public:
    /// @param spread  operands are +-2^e, |e| <= spread, with full mantissas
    Expression(unsigned seed, int operands, int operations, int spread) {
        std::mt19937_64 random(seed);
        for (int i = 0; i < operands; ++i) {
            const double mantissa = 1.0 + static_cast<double>(random() >> 12) * 0x1p-52;
            const int exponent = static_cast<int>(random() % static_cast<unsigned>(2 * spread + 1)) - spread;
            operands_.push_back(std::ldexp(random() % 2 ? mantissa : -mantissa, exponent));
        }
        for (int i = 0; i < operations; ++i) {
            const auto known = static_cast<unsigned>(operands + i);
            steps_.push_back({static_cast<int>(random() % 4), random() % known, random() % known});
        }
    }

    /// @param accept  called with the step and the divisor of each division; false skips it
    template <class Number, class Accept>
    std::vector<Number> values(Accept accept) const {
        std::vector<Number> known;
        for (const double operand : operands_)
            known.push_back(Number(operand));
        for (size_t i = 0; i < steps_.size(); ++i) {
            const Number a = known[steps_[i].a];
            const Number b = known[steps_[i].b];
            switch (steps_[i].kind) {
                case 0:
                    known.push_back(a + b);
                    break;
                case 1:
                    known.push_back(a - b);
                    break;
                case 2:
                    known.push_back(a * b);
                    break;
                default:
                    known.push_back(accept(i, b) ? a / b : a);
            }
        }
        return known;
    }

    /// Which divisions have a divisor that is not zero.
    template <class Number>
    std::vector<bool> possible() const {
        std::vector<bool> possible(steps_.size(), true);
        values<Number>([&](size_t i, const Number& divisor) {
            possible[i] = divisor.sign() != 0;
            return bool(possible[i]);
        });
        return possible;
    }

  private:
    struct Step {
        int kind;
        size_t a, b;
    };
    std::vector<double> operands_;
    std::vector<Step> steps_;
};

}  // namespace type21::reference
