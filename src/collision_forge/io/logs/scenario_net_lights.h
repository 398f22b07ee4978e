#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/base/scene/traffic_light.h"
#include "collision_forge/io/logs/pickle_field.h"

namespace forge {

/// Returns the traffic lights of a scenario description's `dynamic_map_states` that control a lane
/// with a centreline of `map`; other lights are left out without a message. `times`: s, of the
/// rows, strictly increasing; the lights' times are on the same clock. TrafficLight::states has the
/// first row and each row with another colour than the row before. A row without a state is
/// kUnknown, and so is a flashing light, which no vehicle has to wait for. A light without a
/// readable stop point has the lane's first point. Leaves out lights that cannot be read, all if
/// `states` is not a dict; adds a message for each to `problems`.
std::vector<TrafficLight> lightsOf(const PickleField& states, const std::vector<double>& times,
                                   const LaneMap& map, std::vector<std::string>& problems);

}  // namespace forge
