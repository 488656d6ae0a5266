/// @file Stops of a run where an effect leaves its range: temperatures below absolute zero, friction laws that
/// overflow.
#pragma once

#include <string>
#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/host/march.h"
#include "reference/host/state.h"

namespace type21 {

/// Whether the temperatures of a deck count from absolute zero. They do, but for a deck without radiation that imposes
/// a temperature below 0 (/IMPTEMP): its scale is arbitrary, since only differences of temperatures matter then.
/// Formulation 9, step 12.
bool absolute_temperatures(const Model& model);

/// @param absolute  absolute_temperatures() of the model
/// @throws RunStopped naming the coldest node, where a temperature is below absolute zero.  Formulation 9, step 12.
void check_temperatures(const Model& model, const HostState& state, bool absolute);

/// @throws RunStopped naming coefficient, speed and node, where a friction law is not a finite number.
/// Formulation 8, step 7.
void check_friction(const Model& model, const HostState& state, const std::vector<ContactStep>& steps);

/// Friction coefficients that fct_IDF made negative, of one interface: how often, and the first. Plain data: part of
/// the state of a run.  Formulation 8, step 3.
struct BelowZero {
    long count = 0;          ///< nodes, summed over the cycles
    int node = -1;           ///< index into ContactModel::nodes
    double abscissa = 0;     ///< of fct_IDF [temperature]
    double coefficient = 0;  ///< Fric f_IDF [-]
    long cycle = 0;
    double time = 0;  ///< [time]

    template <class Archive>
    void visit_state(Archive& archive) {
        archive(count, node, abscissa, coefficient, cycle, time);
    }
};

/// One sentence for the end of a run.
std::string warning_of(const BelowZero& all, const Model& model, const Interface& card);

/// Says at the end of a run, however it ends, where friction coefficients were below zero.
class FrictionReport {
  public:
    FrictionReport(const Model& model, const HostState& state, const MarchOptions& options);
    FrictionReport(const FrictionReport&) = delete;
    FrictionReport& operator=(const FrictionReport&) = delete;
    ~FrictionReport();

    void note(const std::vector<ContactStep>& steps);

    /// What a checkpoint holds.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(below_zero_);
    }

  private:
    const Model& model_;
    const HostState& state_;
    const MarchOptions& options_;
    std::vector<BelowZero> below_zero_;
};

}  // namespace type21
