/// @file One node at one time of a run: marches to that cycle and accounts for it.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/explain/node_account.h"

namespace type21 {

struct ExplainRequest {
    Id node = 0;
    double time = 0;              ///< [time]
    std::optional<Id> interface;  ///< none: every interface that has the node on its secondary side
};

struct DeckAccount {
    Id node = 0;
    double asked = 0;  ///< the time asked for [time]
    long cycle = 0;
    double time = 0;  ///< t_n of the cycle: the last that is not after the one asked for [time]
    double step = 0;  ///< dt1 [time]
    std::vector<NodeAccount> interfaces;
};

/// There is no such node, interface or time; the message says what there is.
struct ExplainError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A cycle within a share of 1e-9 of the time counts as that time: times are sums of steps.
/// @throws ExplainError, RunStopped where the run ends before the time
DeckAccount explain_deck(const HostScene& scene, const ExplainRequest& request, const MarchOptions& options = {});

std::string account_text(const DeckAccount& account, const Model& model);

}  // namespace type21
