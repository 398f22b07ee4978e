#pragma once

#include <array>

namespace forge {

class Section;

inline constexpr int kMaxHistoryFrames = 256;  ///< 128 s; in config/ and in network files

/// config/prediction.yaml
struct PredictionOptions {
  int history_frames = 0;                  ///< frames at 2 Hz, the one at t0 included
  double min_tta = 0.0;                    ///< s
  double max_tta = 0.0;                    ///< s
  double candidate_radius = 0.0;           ///< m around the ego at t0
  double tail = 0.0;                       ///< s predicted after the impact: SearchOptions::tail
  int ego_samples = 0;                     ///< futures; half for search, half for confidence
  double pattern_tolerance = 0.0;          ///< m of corner distance from a pattern
  double network_pattern_tolerance = 0.0;  ///< m, the same for a network's pattern
};

/// Features of a driving situation (featuresOf()) in order, with the unit of their weights: speed
/// over the last 0.5 s (s/m); acceleration over the last 1 s, 0.5 s earlier, and over the 1 s
/// before (s2/m); turn rate (s/rad); braking for the bend ahead (s2/m), its turn (1/rad) and its
/// curvature (0.1 m); desired over actual gap to the vehicle ahead (1); closing rate (s).
inline constexpr int kSpeedFeatures = 10;
using FeatureWeights = std::array<double, kSpeedFeatures>;

/// config/study/speed_model_fit.yaml
struct SpeedModelFitOptions {
  int intervals = 0;            ///< forecast intervals of kProfileStep
  int centers = 0;              ///< cluster centres in feature space
  int cluster_rounds = 0;       ///< k-means iterations
  int folds = 0;                ///< of scenes, for held-out residuals
  double gain_ridge = 0.0;      ///< ridge penalty of the gains
  double spread_ridge = 0.0;    ///< ridge penalty of the log spreads
  double linear_ridge = 0.0;    ///< ridge penalty of the linear features
  double spread_floor = 0.0;    ///< share of the mean |residual|, added before the log
  int profiles = 0;             ///< residual profiles per forecast
  double standing_speed = 0.0;  ///< m/s; slower egos stand
  int standing_profiles = 0;    ///< profiles per forecast from a standstill
  double standing_ridge = 0.0;  ///< ridge penalty of the standing shares
  /// Scale the feature differences of two situations; a scaled distance of sqrt(3) halves their
  /// similarity.
  FeatureWeights feature_weights = {0.25, 1.0, 0.75, 0.25, 2.5, 0.35, 1.14, 1.3, 0.25, 4.0};
};

/// config/ego_futures.yaml
struct EgoFutureOptions {
  double offset_spread = 0.0;     ///< m, mean |difference| from the expected lateral offset
  double turn_rate_spread = 0.0;  ///< rad/s, mean |difference| from the turn rate at t0, off lanes
  double acceleration_fading = 0.0;  ///< s in which the acceleration at t0 decays to 1/e of it
  double acceleration_spread = 0.0;  ///< m/s2, mean |difference| from the acceleration at t0
};

// Read the struct from its section. Throw ConfigError for a missing key or a value out of range.
void readOptions(Section& section, PredictionOptions& options);
void readOptions(Section& section, SpeedModelFitOptions& options);
void readOptions(Section& section, EgoFutureOptions& options);

}  // namespace forge
