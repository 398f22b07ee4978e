#pragma once

#include <array>

namespace forge {

class Section;

inline constexpr int kMaxHistoryFrames = 256;  ///< 128 s; in config/ and a file of networks alike

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
  double on_lane_distance = 0.0;
  double on_lane_heading = 0.0;
  double standstill_speed = 0.0;
  double lane_return_distance = 0.0;
  double rear_end_closing_speed = 0.0;
  double min_impact_speed = 0.0;
  double pattern_tolerance = 0.0;
  double network_pattern_tolerance = 0.0;
};

inline constexpr int kSpeedFeatures = 10;
using FeatureWeights = std::array<double, kSpeedFeatures>;

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
  double reachable_lane_distance = 0.0;
  double reachable_lane_heading = 0.0;
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
  double step = 0.0;  ///< that of PredictionOptions
  EgoPathOptions paths;
  double lane_return_time = 0.0;
  double lane_return_min_distance = 0.0;
  double kept_offset = 0.0;
  double offset_spread = 0.0;
  double turn_rate_spread = 0.0;
  double acceleration_fading = 0.0;
  double acceleration_spread = 0.0;
};

void readOptions(Section& section, PredictionOptions& options);
void readOptions(Section& section, SpeedModelFitOptions& options);
/// `step` is that of PredictionOptions: all futures have states at the same intervals.
void readOptions(Section& section, EgoFutureOptions& options, double step);

}  // namespace forge
