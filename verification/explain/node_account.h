/// @file Everything of one node of one interface in one cycle, from its place to its force.
#pragma once

#include <vector>

#include "reference/host/march.h"
#include "verification/explain/account.h"
#include "verification/explain/candidate_account.h"
#include "verification/explain/replay.h"

namespace type21 {

struct NodeAccount {
    Id interface = 0;
    std::string interface_title;
    bool active = false;
    AccountSection place;  ///< position, gap, reach
    CandidateAccount candidates;
    std::vector<AccountSection> sections;  ///< retained impact, geometry, offset, normal force, friction, heat, force
    NodeContact node;                      ///< what the ContactStep says
    Replay replay;                         ///< what the laws say again
    /// The replay gives the ContactStep's offset, forces and force vector to the last bit.
    bool agrees = true;
};

/// What an account is made from.
struct AccountInput {
    const HostScene& scene;
    int interface = 0;  ///< index into Model::interfaces
    int node = 0;       ///< rank of the secondary node
    const reference::Inspect& inspect;
    const Motion& motion;
    const ContactStep& step;
    const NodeBefore& before;

    const Model& model() const { return *scene.host; }
    const Interface& card() const { return scene.model->interfaces[static_cast<size_t>(interface)]; }
    int model_node() const { return card().secondary.node[static_cast<size_t>(node)]; }
    std::string unit(Dimension dimension) const { return scene.host->units.name(dimension); }
};

NodeAccount account_node(const AccountInput& input);

/// The parts, in their order.
AccountSection place_section(const AccountInput& input);
AccountSection impact_section(const AccountInput& input, const NodeAccount& account);
AccountSection geometry_section(const AccountInput& input, const NodeContact& node);
AccountSection offset_section(const AccountInput& input, const NodeContact& node, const Replay& replay);
AccountSection normal_section(const AccountInput& input, const NodeContact& node, const Replay& replay);
AccountSection friction_section(const AccountInput& input, const NodeContact& node, const Replay& replay);
AccountSection heat_section(const AccountInput& input, const NodeContact& node);
AccountSection force_section(const AccountInput& input, const NodeAccount& account);

/// Nine digits, as all text has them; JSON has all.
std::string digits(double value);
std::string digits(const Vec3& value);

}  // namespace type21
