#pragma once

#include <cstdint>
#include <iterator>
#include <map>
#include <vector>

#include "scene/collision_request.h"

namespace forge {

/// config/vehicle_limits.yaml, where each number's unit and source stand.
struct VehicleLimits {
  double max_forward_acceleration = 0.0;
  double max_braking = 0.0;
  double max_total_acceleration = 0.0;
  double max_curvature = 0.0;
  double max_speed = 0.0;
  double curvature_min_speed = 0.0;
  double heading_slack = 0.0;
  double heading_per_metre = 0.0;
};

/// One entry of config/collision_types.yaml: bands of |relative heading|, radians.
struct TypeDefinition {
  double min_heading = 0.0;  ///< at first contact
  double max_heading = 0.0;
  double nominal_heading = 0.0;
  double min_approach = 0.0;  ///< now
  double max_approach = 0.0;
};
using TypeDefinitions = std::map<CollisionType, TypeDefinition>;

/// config/prediction.yaml
struct PredictionOptions {
  int history_frames = 0;
  int min_history_frames = 0;
  int motion_frames = 0;
  double min_tta = 0.0;
  double max_tta = 0.0;
  double candidate_radius = 0.0;
  double step = 0.0;
  double tail = 0.0;
  double lane_max_distance = 0.0;
  double lane_max_heading = 0.0;
  double standstill_speed = 0.0;
  double lane_return_distance = 0.0;
  double rear_end_closing_speed = 0.0;
  double min_impact_speed = 0.0;
};

/// config/realization.yaml, section realization
struct RealizationOptions {
  double step = 0.0;
  double tail = 0.0;
  double depth = 0.0;
  int samples = 0;
  double heading_spread = 0.0;
  double slide_spread = 0.0;
  double min_speed_factor = 0.0;
  double max_speed_factor = 0.0;
  int compared = 0;
  double off_road_weight = 0.0;
};

/// config/realization.yaml, section verification
struct VerificationOptions {
  double time_tolerance = 0.0;
  double overlap_tolerance = 0.0;
  double off_road_interval = 0.0;
  std::vector<double> confidence_speed_factors;
};

/// Everything that the road from a snapshot to an attacker trajectory is tuned by.
struct AttackOptions {
  VehicleLimits vehicle_limits;
  TypeDefinitions collision_types;
  PredictionOptions prediction;
  RealizationOptions realization;
  VerificationOptions verification;
};

/// For whom a list of requests asks: for any attacker, or for each possible one by its id.
enum class Attackers { kAny, kEach };

/// What a list of requests is made of; stride, ttas and min_ego_speed by default those of
/// config/requests.yaml, where their units stand.
struct RequestListOptions {
  double stride = 0.0;
  std::vector<double> ttas;
  double min_ego_speed = 0.0;
  std::vector<CollisionType> types{std::begin(kCollisionTypes), std::end(kCollisionTypes)};
  Attackers attackers = Attackers::kAny;
  std::uint64_t seed = 0;  ///< of every request
};

}  // namespace forge
