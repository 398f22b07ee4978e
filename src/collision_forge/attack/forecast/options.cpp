#include "collision_forge/attack/forecast/options.h"

#include "collision_forge/base/config/section.h"

namespace forge {

void readOptions(Section& section, PredictionOptions& options) {
  options.history_frames = section.count("history_frames", 1, kMaxHistoryFrames);
  options.min_history_frames = section.count("min_history_frames", 1, options.history_frames);
  options.motion_frames = section.count("motion_frames", 2);
  options.min_tta = section.positive("min_tta");
  options.max_tta = section.atLeast("max_tta", options.min_tta);
  options.candidate_radius = section.positive("candidate_radius");
  options.step = section.positive("step");
  options.tail = section.positive("tail");
  options.ego_samples = section.count("ego_samples", 2);
  options.on_lane_distance = section.nonNegative("on_lane_distance");
  options.on_lane_heading = section.angle("on_lane_heading");
  options.standstill_speed = section.nonNegative("standstill_speed");
  options.lane_return_distance = section.positive("lane_return_distance");
  options.rear_end_closing_speed = section.positive("rear_end_closing_speed");
  options.min_impact_speed = section.nonNegative("min_impact_speed");
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

static void readOptions(Section& section, EgoPathOptions& options) {
  constexpr double kMaxLaneHeading = 1.5;  // rad; an ego that crosses a lane does not follow it
  options.reachable_lane_distance = section.nonNegative("reachable_lane_distance");
  options.reachable_lane_heading = section.within("reachable_lane_heading", 0.0, kMaxLaneHeading);
  options.max_lanes = section.count("max_lanes", 0);
  options.max_paths_per_lane = section.count("max_paths_per_lane", 1);
  options.near_deviation_cost = section.nonNegative("near_deviation_cost");
  options.far_deviation_cost = section.nonNegative("far_deviation_cost");
  options.bend_braking_cost = section.nonNegative("bend_braking_cost");
  options.turn_cost = section.nonNegative("turn_cost");
  options.free_path_cost = section.nonNegative("free_path_cost");
  options.comfortable_lateral_acceleration = section.positive("comfortable_lateral_acceleration");
  options.turn_rate_fading = section.positive("turn_rate_fading");
}

void readOptions(Section& section, EgoFutureOptions& options, double step) {
  options.step = step;
  section.read("paths", options.paths);
  Section lateral = section.section("lateral");
  options.lane_return_time = lateral.positive("lane_return_time");
  options.lane_return_min_distance = lateral.positive("lane_return_min_distance");
  options.kept_offset = lateral.share("kept_offset");
  options.offset_spread = lateral.nonNegative("offset_spread");
  options.turn_rate_spread = lateral.nonNegative("turn_rate_spread");
  lateral.finish();
  Section no_profiles = section.section("no_profiles");
  options.acceleration_fading = no_profiles.positive("acceleration_fading");
  options.acceleration_spread = no_profiles.nonNegative("acceleration_spread");
  no_profiles.finish();
}

}  // namespace forge
