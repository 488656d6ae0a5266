/// @file Ways to break a contact from outside, by a change of its input or of its output. The contact itself, the host,
/// the criteria and the balances are unchanged.
#pragma once

#include <optional>

#include "verification/criteria/mutation/mutation.h"

namespace type21 {

/// The contact is given another card; `without` is taken from its effects.
BreakContact broken_card(std::function<void(ContactModel&, Interface&)> change, std::optional<Effect> without = {});
/// The contact computes without an effect.
BreakContact without_effect(Effect effect);
/// The contact is given another motion.
BreakContact broken_motion(std::function<void(Motion&, const Interface&)> change);

/// Changes the output of a contact in a cycle. There is one for each interface, so it may keep a state.
using BreakStep = std::function<void(ContactStep&, const Motion&)>;
BreakContact broken_step(std::function<BreakStep(const Scene&, int interface)> make);
/// The same without a state.
BreakContact broken_sums(std::function<void(ContactStep&)> change);
/// Changes each node in contact, then forms the sums again.
BreakContact broken_nodes(std::function<void(NodeContact&)> change);

/// Makes a new contact in every cycle, so that its state is lost.
BreakContact forgetful();

/// Whether the interface computes the effect.
std::function<bool(const HostScene&, int)> has_effect(Effect effect);
/// Whether the time step is not fixed by /DTIX.
bool own_step(const HostScene& scene, int interface);
/// Whether the card of the interface meets a condition.
std::function<bool(const HostScene&, int)> has_card(std::function<bool(const Interface&)> such);

/// Forms the sums and the loads of the tool, except its damping, from the nodes.
void sum_again(ContactStep& step, const Motion& motion, const Interface& card);

}  // namespace type21
