#pragma once

#include <vector>

#include "collision_forge/map/lane_queries.h"
#include "collision_forge/planners/circle_chain.h"
#include "collision_forge/planners/rule_based_options.h"
#include "collision_forge/scene/track.h"

namespace forge {

/// Somebody as the planner expects it.
struct ExpectedAgent {
  CircleChain chain;
  /// Equally possible; each a place for every step, the first now.
  std::vector<std::vector<PlacedChain>> futures;
};

/// The lanes that an agent may be driving on: those that LaneIndex::lanesNear() finds, and of lanes
/// that follow each other the nearest alone.
std::vector<LaneMatch> drivenLanes(const LaneIndex& lanes, const Pose2& agent,
                                   const RuleBasedOptions& options);

/// What an agent may do from its newest state on: along every path ahead of every lane that it may
/// be driving on, bent through it, or straight on along its heading where it is on none, at each of
/// the shares of its speed, which it takes on by a share of the greatest acceleration. Who stands
/// keeps standing.
ExpectedAgent expectedAgent(const Track& agent, const LaneIndex& lanes,
                            const RuleBasedOptions& options);

}  // namespace forge
