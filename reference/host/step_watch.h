/// @file Watches a step that the engine deck forces: is it stable, and does the run come to its end
/// (Formulation 11, step 3)?
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reference/contract/contact_step.h"
#include "reference/deck/problem.h"
#include "reference/host/state.h"
#include "reference/host/time_step.h"

namespace type21 {

/// A run of more cycles is said beforehand: some ten minutes for the smallest scene, weeks for a large one.
inline constexpr double many_cycles = 1e8;
/// A run of more cycles is refused: it would take years.
inline constexpr double most_cycles = 1e12;

/// Judges the step that the engine deck forces before the first cycle.  An error where the time would not move on
/// (t + dt = t before the end) or where more than most_cycles are asked for, a warning above many_cycles; both say how
/// many.
void check_time_span(const Model& model, Problems& problems);

/// Judges dt2 of a cycle.
/// @throws RunStopped where it is not a positive number, below the smallest of /DT, does not change the time, or would
/// need more than most_cycles to the end
void check_step(const Model& model, const HostState& state, double step);

/// How often and how far a run went beyond its stability limit. Plain data: part of the state of a run.
struct StepExcess {
    long cycles = 0;        ///< with a step above the limit
    long first_cycle = 0;   ///< the first of them
    double first_time = 0;  ///< [time]
    double worst = 0;       ///< largest step / limit [-]
    double limit = 0;       ///< the limit there [time]
    double step = 0;        ///< the step there [time]
    long last_cycle = -1;   ///< the last of them
    bool long_run = false;  ///< the warning of very many cycles has been given

    /// A run that goes on says again that it is long: its warnings are its own.
    template <class Archive>
    void visit_state(Archive& archive) {
        archive(cycles, first_cycle, first_time, worst, limit, step, last_cycle);
    }
};

/// The step of this cycle would need more than many_cycles to the end, and no card says so before the run.
bool is_long_run(const Model& model, const HostState& state, double step);
std::string warning_of_long_run(const Model& model, const HostState& state, double step);

/// The stability limit of what the contact can move: nodes that are free in some direction, tools likewise. Nodes and
/// tools that are driven throughout cannot become unstable.
/// @return [time], infinite where nothing can move.  Formulation 11, step 3.
double free_limit(const Model& model, const HostState& state, const std::vector<ContactStep>& contacts);

/// Counts a step that is beyond the limit of the free masses or of heat.
/// @param limits  of the cycle, from TimeStep
void note_excess(const Model& model, const HostState& state, const std::vector<ContactStep>& contacts,
                 const StepLimits& limits, double step, StepExcess& excess);

/// One sentence for the end of a run; none where no step was too large.
std::optional<std::string> warning_of(const StepExcess& excess, const Model& model, long cycles);

}  // namespace type21
