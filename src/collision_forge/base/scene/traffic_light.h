#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Colour that a traffic light shows, arrows and flashing lights included.
enum class LightColor { kUnknown, kRed, kYellow, kGreen };

/// Colour of a light from a time on, until the next state.
struct LightState {
  double time = 0.0;  ///< s, on the scene's clock
  LightColor color = LightColor::kUnknown;
};

/// The recorded states of the traffic light of one lane.
struct TrafficLight {
  std::string lane;                      ///< id of the lane behind the stop line
  Vector2 stop_point = Vector2::Zero();  ///< m, global map frame: where vehicles stop, on the lane
  std::vector<LightState> states;        ///< changes of colour, times strictly increasing
};

/// Returns the colour at `time` (s, scene clock): of the last state at or before it (without
/// tolerance); kUnknown before the first.
LightColor colorAt(const TrafficLight& light, double time);

/// Returns the lights with `shift` (s, may be negative) added to all times.
std::vector<TrafficLight> shifted(std::vector<TrafficLight> lights, double shift);

/// Returns the ids of the lanes whose light is red at `time` (s, scene clock), in the order of
/// `lights`.
std::vector<std::string> redLanes(const std::vector<TrafficLight>& lights, double time);

}  // namespace forge
