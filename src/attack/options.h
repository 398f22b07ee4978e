#pragma once

#include <array>
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

inline constexpr int kSpeedFeatures = 10;
using FeatureWeights = std::array<double, kSpeedFeatures>;

/// config/ego_futures.yaml, section speed
struct SpeedProfileOptions {
  int neighbors = 0;
  double ridge = 0.0;
  double residual_scale = 0.0;
  FeatureWeights feature_weights = {};  ///< in the order of the keys of feature_weights
};

/// config/ego_futures.yaml, section paths
struct EgoPathOptions {
  double lane_max_distance = 0.0;
  double lane_max_heading = 0.0;
  int max_lanes = 0;
  int max_paths_per_lane = 0;
  double near_deviation_cost = 0.0;
  double far_deviation_cost = 0.0;
  double bend_braking_cost = 0.0;
  double turn_cost = 0.0;
  double free_path_cost = 0.0;
  double comfortable_lateral_acceleration = 0.0;
  double turn_rate_fading = 0.0;
};

/// config/ego_futures.yaml
struct EgoFutureOptions {
  double step = 0.0;
  EgoPathOptions paths;
  SpeedProfileOptions speed;
  double lane_return_time = 0.0;
  double lane_return_min_distance = 0.0;
  double kept_offset = 0.0;
  double offset_spread = 0.0;
  double turn_rate_spread = 0.0;
  double acceleration_fading = 0.0;
  double acceleration_spread = 0.0;
};

/// Everything that the road from a snapshot to an attacker trajectory is tuned by.
struct AttackOptions {
  VehicleLimits vehicle_limits;
  TypeDefinitions collision_types;
  PredictionOptions prediction;
  RealizationOptions realization;
  VerificationOptions verification;
  EgoFutureOptions ego_futures;
};

}  // namespace forge
