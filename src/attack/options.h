#pragma once

#include <array>
#include <cstdint>
#include <iterator>
#include <vector>

#include "scene/collision_types.h"

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
  int ego_samples = 0;
  double lane_max_distance = 0.0;
  double lane_max_heading = 0.0;
  double standstill_speed = 0.0;
  double lane_return_distance = 0.0;
  double rear_end_closing_speed = 0.0;
  double min_impact_speed = 0.0;
};

/// config/search.yaml, section bicycle
struct BicycleOptions {
  int iterations = 0;
  double convergence = 0.0;
  double max_miss = 0.0;
  double turn_heading = 0.0;
  double position_scale = 0.0;
  double heading_scale = 0.0;
  double speed_scale = 0.0;
  double acceleration_scale = 0.0;
  double curvature_scale = 0.0;
};

/// config/search.yaml, section steering
struct SteeringOptions {
  double step = 0.0;
  int first_population = 0;
  int population = 0;
  int elites = 0;
  int rounds = 0;
  int considered = 0;
  int patience = 0;
  double hopeless = 0.0;
  double acceleration_deviation = 0.0;
  double curvature_deviation = 0.0;
  double least_acceleration_deviation = 0.0;
  double least_curvature_deviation = 0.0;
  double heading_weight = 0.0;
  double clearance = 0.0;
  double near = 0.0;
};

/// config/search.yaml, section search
struct SearchOptions {
  double step = 0.0;
  double tail = 0.0;
  double depth = 0.0;
  double limit_margin = 0.0;
  double heading_margin = 0.0;
  double time_margin = 0.0;
  double overlap_margin = 0.0;
  int max_attackers = 0;
  int lane_paths = 0;
  int ego_poses = 0;
  int draws = 0;
  double max_lead = 0.0;
  int kept = 0;
  int rounds = 0;
  int perturbations = 0;
  int bicycle_targets = 0;
  int bicycle_rounds = 0;
  int bicycle_perturbations = 0;
  double good_share = 0.0;
  double good_off_road = 0.0;
  double good_steering = 0.0;
  double off_road_weight = 0.0;
  double effort_weight = 0.0;
  double steering_weight = 0.0;
  double quick_steering = 0.0;
  double closeness_weight = 0.0;
  std::vector<double> confidence_curve;  ///< at shares evenly spread over [0, 1]
  double min_confidence = 0.0;
};

/// config/verification.yaml
struct VerificationOptions {
  double time_tolerance = 0.0;
  double overlap_tolerance = 0.0;
  double off_road_interval = 0.0;
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

/// config/speed_model_fit.yaml
struct SpeedModelFitOptions {
  int intervals = 0;
  int centers = 0;
  int cluster_rounds = 0;
  int folds = 0;
  double gain_ridge = 0.0;
  double spread_ridge = 0.0;
  double linear_ridge = 0.0;
  double spread_floor = 0.0;
  int profiles = 0;
  double standing_speed = 0.0;
  int standing_profiles = 0;
  double standing_ridge = 0.0;
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
  TypeRules type_rules = TypeRules::kFull;
  TypeDefinitions collision_types;
  PredictionOptions prediction;
  SearchOptions search;
  BicycleOptions bicycle;
  SteeringOptions steering;
  VerificationOptions verification;
  EgoFutureOptions ego_futures;
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
