#pragma once

#include <array>

namespace forge {

class Section;

inline constexpr int kMaxHistoryFrames = 256;  ///< 128 s; in config/ and a file of networks alike

/// config/prediction.yaml
struct PredictionOptions {
  int history_frames = 0;
  double min_tta = 0.0;
  double max_tta = 0.0;
  double candidate_radius = 0.0;
  double tail = 0.0;  ///< s predicted beyond the impact: SearchOptions::tail
  int ego_samples = 0;
  double pattern_tolerance = 0.0;
  double network_pattern_tolerance = 0.0;
};

/// The features of a driving situation (featuresOf()), in this order, with the unit of their
/// weights: speed over the last 0.5 s (s/m); acceleration over the last 1 s, 0.5 s earlier, and
/// over the 1 s before that (s2/m); turn rate (s/rad); braking for the bend ahead (s2/m), its turn
/// (1/rad) and its curvature (0.1 m); wished over actual gap to the vehicle ahead; closing in on it
/// (s).
inline constexpr int kSpeedFeatures = 10;
using FeatureWeights = std::array<double, kSpeedFeatures>;

/// config/study/speed_model_fit.yaml
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
  /// Of a difference between two situations; 1 halves how near they are at sqrt(3).
  FeatureWeights feature_weights = {0.25, 1.0, 0.75, 0.25, 2.5, 0.35, 1.14, 1.3, 0.25, 4.0};
};

/// config/ego_futures.yaml
struct EgoFutureOptions {
  double offset_spread = 0.0;
  double turn_rate_spread = 0.0;
  double acceleration_fading = 0.0;
  double acceleration_spread = 0.0;
};

void readOptions(Section& section, PredictionOptions& options);
void readOptions(Section& section, SpeedModelFitOptions& options);
void readOptions(Section& section, EgoFutureOptions& options);

}  // namespace forge
