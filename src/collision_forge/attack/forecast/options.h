#pragma once

#include <array>

namespace forge {

class Section;

/// 128 s; largest history_frames in config/ and in network files
inline constexpr int kMaxHistoryFrames = 256;

/// config/prediction.yaml: observed past, and prediction of the ego and the other agents
struct PredictionOptions {
  int history_frames = 0;  ///< frames at 2 Hz that methods observe, the one at t0 included
  double min_tta = 0.0;    ///< s from t0 to impact; a request with a smaller tta is rejected
  double max_tta = 0.0;    ///< s from t0 to impact; a request with a larger tta is rejected
  /// m; largest distance of the box centres of ego and candidate at t0
  double candidate_radius = 0.0;
  double tail = 0.0;  ///< s predicted after the impact; not read, set to SearchOptions::tail
  /// sampled futures of the ego, at least 2; half for search, half for confidence
  int ego_samples = 0;
  double pattern_tolerance = 0.0;  ///< m; CollisionPattern::tolerance of patterns without a network
  /// m; CollisionPattern::tolerance of patterns of a network
  double network_pattern_tolerance = 0.0;
};

/// Features of a driving situation (featuresOf()) in order, with the unit of their weights: speed
/// over the last 0.5 s (s/m); acceleration over the last 1 s, 0.5 s earlier, and over the 1 s
/// before (s2/m); turn rate (s/rad); braking for the bend ahead (s2/m), its turn (1/rad) and its
/// curvature (0.1 m); desired over actual gap to the vehicle ahead (1); closing rate (s).
inline constexpr int kSpeedFeatures = 10;
using FeatureWeights = std::array<double, kSpeedFeatures>;

/// config/study/speed_model_fit.yaml: parameters of fitSpeedModel(); `feature_weights` is not read,
/// its values are fixed here
struct SpeedModelFitOptions {
  int intervals = 0;  ///< most forecast intervals of kProfileStep
  int centers = 0;    ///< most cluster centres in feature space, and at most one per 8 profiles
  int cluster_rounds = 0;  ///< k-means iterations
  int folds = 0;  ///< groups of scenes, for held-out residuals; at least 2, at most one per scene
  double gain_ridge = 0.0;    ///< ridge penalty of the gains
  double spread_ridge = 0.0;  ///< ridge penalty of the log spreads
  double linear_ridge = 0.0;  ///< ridge penalty of the linear features
  /// share of the mean |residual|, added to each |residual| before the log
  double spread_floor = 0.0;
  int profiles = 0;             ///< residual profiles per forecast
  double standing_speed = 0.0;  ///< m/s; a slower ego stands
  int standing_profiles = 0;    ///< profiles per forecast from a standstill
  double standing_ridge = 0.0;  ///< ridge penalty of the standing shares
  /// Factor per feature, in the order and with the units above kSpeedFeatures, before two
  /// situations are compared; a scaled distance of sqrt(3) halves their similarity.
  FeatureWeights feature_weights = {0.25, 1.0, 0.75, 0.25, 2.5, 0.35, 1.14, 1.3, 0.25, 4.0};
};

/// config/ego_futures.yaml: spreads of KinematicEgoFutures. Differences are Laplace distributed.
struct EgoFutureOptions {
  double offset_spread = 0.0;  ///< m, mean |difference| from the expected lateral offset, which is
                               ///< kKeptOffset times the one at t0
  double turn_rate_spread = 0.0;  ///< rad/s, mean |difference| from the turn rate at t0, off lanes
  double acceleration_fading = 0.0;  ///< s in which the acceleration at t0 decays to 1/e of it
  double acceleration_spread = 0.0;  ///< m/s2, mean |difference| from the acceleration at t0
};

// Read the struct from its section. Throw ConfigError for a missing key or a value out of range.
void readOptions(Section& section, PredictionOptions& options);
void readOptions(Section& section, SpeedModelFitOptions& options);
void readOptions(Section& section, EgoFutureOptions& options);

}  // namespace forge
