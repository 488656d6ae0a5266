/// @file All sums over the nodes of one cycle.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "optimized/sums/exact_accumulator.h"
#include "reference/contract/contact_step.h"

namespace type21::optimized {

/// One number of a node for each sum, and a row of a block for each of these.
enum class Term : int {
    normal_x,
    normal_y,
    normal_z,  // -F_n nu
    tangential_x,
    tangential_y,
    tangential_z,  // F_t
    abs_normal_x,
    abs_normal_y,
    abs_normal_z,
    abs_total_x,
    abs_total_y,
    abs_total_z,    // |components of the force on the tool|
    signed_normal,  // -F_n
    norm_total,
    friction_work,
    damping_work,
    elastic_energy,
    force_x,
    force_y,
    force_z,  // on the tool
    moment_x,
    moment_y,
    moment_z,  // about x_G
    stiffness,
    rotation,
    step_stiffness,
    step_rotation,
    friction_heat,
    heat_to_blank,
    heat_to_tool,
    count
};

/// Rows of terms of up to `capacity` nodes. They are summed a block at a time, while they are in the cache.
class TermBlock {
  public:
    static constexpr int capacity = 64;

    double* column() { return value_.data() + size_; }
    static constexpr int stride = capacity;
    void next() { ++size_; }
    int size() const { return size_; }
    void clear() { size_ = 0; }
    const double* row(int term) const { return value_.data() + term * capacity; }
    double* row(Term term) { return value_.data() + static_cast<int>(term) * capacity; }
    void resize(int columns) { size_ = columns; }

  private:
    alignas(64) std::array<double, static_cast<size_t>(Term::count) * capacity> value_;
    int size_ = 0;
};

struct StepSums {
    std::array<ExactAccumulator, static_cast<size_t>(Term::count)> sum;

    void add(const TermBlock& block, int terms) {
        for (int t = 0; t < terms; ++t)
            sum[static_cast<size_t>(t)].add_block(block.row(t), block.size());
    }
    void add(const TermBlock& block, std::span<const Term> terms) {
        for (const Term t : terms)
            sum[static_cast<size_t>(t)].add_block(block.row(static_cast<int>(t)), block.size());
    }
    void add(const StepSums& other) {
        for (size_t t = 0; t < sum.size(); ++t)
            sum[t].add(other.sum[t]);
    }
    /// Without friction the whole force is the normal force.
    void without_friction() {
        for (int i = 0; i < 3; ++i) {
            at(Term::force_x, i) = at(Term::normal_x, i);
            at(Term::abs_total_x, i) = at(Term::abs_normal_x, i);
        }
    }
    void clear() {
        for (ExactAccumulator& s : sum)
            s.clear();
    }
    ExactAccumulator& at(Term first, int i) { return sum[static_cast<size_t>(first) + static_cast<size_t>(i)]; }
    ExactAccumulator& operator[](Term term) { return sum[static_cast<size_t>(term)]; }
    double value(Term term) const { return sum[static_cast<size_t>(term)].value(); }
    Vec3 vector(Term first) const {
        const auto at = static_cast<size_t>(first);
        return {sum[at].value(), sum[at + 1].value(), sum[at + 2].value()};
    }
};

}  // namespace type21::optimized
