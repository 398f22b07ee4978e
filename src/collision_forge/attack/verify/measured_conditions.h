#pragma once

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Sets `gap` and `headway` of `measured` from the states (box centres, global map frame) and boxes
/// of both vehicles at t0; leaves its other fields unchanged. The gap is the distance of the
/// centres minus half of both lengths, at least 0; the headway is the gap over the speed of the
/// vehicle behind, at most kNoHeadway.
void measureStart(const AgentState& ego, const BoxSize& ego_size, const AgentState& attacker,
                  const BoxSize& attacker_size, ContactConditions& measured);

/// Returns the quantities of ContactConditions for a trajectory that touches the ego, from
/// `report.contact_time`, the poses and relative heading at contact and `report.attacker_side`,
/// which must be set. t0 is the time of the trajectory's first point; `future` has the ego and
/// other agents from then on. Neither the trajectory nor the ego's track may be empty.
ContactConditions measuredConditions(const AttackerTrajectory& trajectory,
                                     const CollisionReport& report, const Future& future);

}  // namespace forge
