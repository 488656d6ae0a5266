/// @file A mutation: one effect of the contact broken on purpose. At least one criterion must then fail.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "reference/host/march.h"
#include "verification/decisions/queries/decision_block.h"

namespace type21 {

/// Makes the broken contact of an interface from the sound one.
using BreakContact =
    std::function<std::unique_ptr<ContactMethod>(const Scene&, int interface, const MakeContact& sound)>;
/// The answer to a question with broken rules.
using BreakDecision = std::function<DecisionAnswer(const DecisionTool&, const ContactQuery&)>;

struct Mutation {
    std::string name;    ///< "friction_off"
    std::string effect;  ///< what is broken, with the equation or field where there is one
    std::string broken;  ///< how, in words
    std::function<bool(const HostScene&, int interface)> concerns;  ///< whether the interface has the effect
    BreakContact contact;                                           ///< tested by the criteria of the cases
    BreakDecision decision;                                         ///< or by the exact answers of cases/decisions
};

/// All of them, in the order of the formulation.
const std::vector<Mutation>& mutations();

// Parts of the table.
std::vector<Mutation> decision_mutations();
std::vector<Mutation> force_mutations();
std::vector<Mutation> friction_mutations();
std::vector<Mutation> heat_mutations();
std::vector<Mutation> tool_mutations();

}  // namespace type21
