/// @file Ways to break a contact without a word in its code: what goes in is changed, or what comes out.
/// The host, the checks and the balances know nothing of it.
#pragma once

#include <optional>

#include "verification/criteria/mutation/mutation.h"

namespace type21 {

/// The contact is given another card; `without` is taken from its effects.
BreakContact broken_card(std::function<void(Model&, Interface&)> change, std::optional<Effect> without = {});
/// The contact computes without an effect.
BreakContact without_effect(Effect effect);
/// The contact is given another motion.
BreakContact broken_motion(std::function<void(Motion&, const Interface&)> change);

/// Changes what a contact says of a cycle; one for each interface, so that it may remember.
using BreakStep = std::function<void(ContactStep&, const Motion&)>;
BreakContact broken_step(std::function<BreakStep(const Scene&, int interface)> make);
/// The same where nothing is remembered.
BreakContact broken_sums(std::function<void(ContactStep&)> change);
/// Each node in contact is changed, then the sums are formed again.
BreakContact broken_nodes(std::function<void(NodeContact&)> change);

/// A new contact in every cycle: nothing is remembered.
BreakContact forgetful();

/// Whether the interface computes the effect.
std::function<bool(const HostScene&, int)> has_effect(Effect effect);
/// Whether the scene's step is not given by /DTIX alone.
bool own_step(const HostScene& scene, int interface);
/// Whether the interface's card is such.
std::function<bool(const HostScene&, int)> has_card(std::function<bool(const Interface&)> such);

/// Sums and loads of the tool, but for its damping, from the nodes as they are.
void sum_again(ContactStep& step, const Motion& motion, const Interface& card);

}  // namespace type21
