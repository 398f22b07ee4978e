#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/planner_test/planners/planner.h"

namespace forge {

/// Returns true for the Track::id of an object of withRedLights().
bool isRedLight(const std::string& agent_id);

/// Returns the agents of an observation and after them, in the order of `route`, as nuPlan's
/// planners see a red light, a standing static object (1 m long, 2 m wide) just beyond the stop
/// line (start) of each lane in `route` whose light is red. `route`: indices in lanes.map().lanes,
/// in driving order. The object has one state at the observation's time. nuPlan takes the whole
/// lane connector; here it is its first metre, so that a light does not stop an ego that has passed
/// it. Leaves out lights that the front of the ego's box (size `ego`, m) has passed.
std::vector<Track> withRedLights(const Observation& observation, const BoxSize& ego,
                                 const LaneIndex& lanes, const std::vector<std::size_t>& route);

}  // namespace forge
