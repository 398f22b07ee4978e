#include "collision_forge/attack/forecast/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, PredictionOptions& options) {
  options.history_frames = section.count("history_frames", 1, kMaxHistoryFrames);
  options.min_tta = section.positive("min_tta");
  options.max_tta = section.atLeast("max_tta", options.min_tta);
  options.candidate_radius = section.positive("candidate_radius");
  options.ego_samples = section.count("ego_samples", 2);
  options.pattern_tolerance = section.nonNegative("pattern_tolerance");
  options.network_pattern_tolerance = section.nonNegative("network_pattern_tolerance");
}

void readOptions(Section& section, SpeedModelFitOptions& options) {
  options.intervals = section.count("intervals", 1);
  options.centers = section.count("centers", 1);
  options.cluster_rounds = section.count("cluster_rounds", 1);
  options.folds = section.count("folds", 2);
  options.gain_ridge = section.positive("gain_ridge");
  options.spread_ridge = section.positive("spread_ridge");
  options.linear_ridge = section.positive("linear_ridge");
  options.spread_floor = section.positive("spread_floor");
  options.profiles = section.count("profiles", 1);
  options.standing_speed = section.nonNegative("standing_speed");
  options.standing_profiles = section.count("standing_profiles", 1);
  options.standing_ridge = section.positive("standing_ridge");
}

void readOptions(Section& section, EgoFutureOptions& options) {
  options.offset_spread = section.nonNegative("offset_spread");
  options.turn_rate_spread = section.nonNegative("turn_rate_spread");
  options.acceleration_fading = section.positive("acceleration_fading");
  options.acceleration_spread = section.nonNegative("acceleration_spread");
}

}  // namespace forge
