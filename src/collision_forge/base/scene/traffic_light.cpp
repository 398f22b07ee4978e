#include "collision_forge/base/scene/traffic_light.h"

#include <algorithm>

namespace forge {

LightColor colorAt(const TrafficLight& light, double time) {
  const auto next =
      std::upper_bound(light.states.begin(), light.states.end(), time,
                       [](double at, const LightState& state) { return at < state.time; });
  return next == light.states.begin() ? LightColor::kUnknown : std::prev(next)->color;
}

std::vector<TrafficLight> shifted(std::vector<TrafficLight> lights, double shift) {
  for (TrafficLight& light : lights) {
    for (LightState& state : light.states) state.time += shift;
  }
  return lights;
}

std::vector<std::string> redLanes(const std::vector<TrafficLight>& lights, double time) {
  std::vector<std::string> lanes;
  for (const TrafficLight& light : lights) {
    if (colorAt(light, time) == LightColor::kRed) lanes.push_back(light.lane);
  }
  return lanes;
}

}  // namespace forge
