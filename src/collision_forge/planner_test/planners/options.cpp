#include "collision_forge/planner_test/planners/options.h"

#include <algorithm>
#include <limits>

#include "collision_forge/base/config/section.h"

namespace forge {
namespace {

constexpr double kMaxTtc = 60.0;      // s
constexpr double kMaxOffset = 10.0;   // m
constexpr double kMinSpacing = 0.05;  // m
constexpr double kMaxSpeedShare = 2.0;
constexpr double kMaxSteering = 1.5;  // rad; short of a wheel across the car

IdmParameters readIdmLaw(Section& section) {
  IdmParameters law;
  law.desired_speed = section.positive("desired_speed");
  law.time_headway = section.nonNegative("time_headway");
  law.max_acceleration = section.positive("max_acceleration");
  law.braking = section.positive("braking");
  law.min_gap = section.nonNegative("min_gap");
  law.exponent = section.positive("exponent");
  return law;
}

/// Those of STRIVE's two sets of parameters that differ.
RuleBasedOptions withParameters(RuleBasedOptions options, Section section) {
  options.max_speed = section.positive("max_speed");
  options.max_acceleration = section.positive("max_acceleration");
  options.distance_weight = section.nonNegative("distance_weight");
  options.distance_weight_rate = section.nonNegative("distance_weight_rate");
  section.finish();
  return options;
}

void readRuleBased(Section section, PlannerOptions& planners) {
  RuleBasedOptions options;
  options.step = section.atLeast("step", kMinTimeStep);
  options.steps = section.count("steps", 2);
  options.middle_speeds = section.count("middle_speeds", 1);
  options.end_speeds = section.count("end_speeds", 1);
  options.interaction_radius = section.nonNegative("interaction_radius");
  options.speed_shares = section.numbers("speed_shares", 0.0, kMaxSpeedShare);
  options.acceleration_shares = section.positives("acceleration_shares");
  options.on_lane_distance = section.nonNegative("on_lane_distance");
  options.on_lane_heading = section.angle("on_lane_heading");
  options.max_paths = section.count("max_paths", 1);
  options.length_buffer = section.nonNegative("length_buffer");
  options.bend_length = section.positive("bend_length");
  options.sample_spacing = section.atLeast("sample_spacing", kMinSpacing);
  options.node_spacing = section.atLeast("node_spacing", kMinSpacing);
  options.max_probability = section.share("max_probability");
  options.ego_way = section.choice<EgoWay>(
      "ego_way", {{"first", EgoWay::kFirst}, {"along_route", EgoWay::kAlongRoute}});
  planners.rule_based = withParameters(options, section.section("published"));
  planners.tuned_rule_based = withParameters(options, section.section("tuned"));
  section.finish();
}

}  // namespace

static void readOptions(Section& section, KinematicBicycleOptions& options,
                        const VehicleLimits& limits) {
  options.wheelbase = section.positive("wheelbase");
  options.max_steering = section.within("max_steering", 0.0, kMaxSteering);
  options.max_acceleration = limits.max_forward_acceleration;
  options.max_braking = limits.max_braking;
  options.acceleration_lag = section.nonNegative("acceleration_lag");
  options.steering_lag = section.nonNegative("steering_lag");
}

static void readOptions(Section& section, LqrOptions& options) {
  options.step = section.atLeast("step", kMinTimeStep);
  options.horizon = section.count("horizon", 1);
  options.speed_weight = section.positive("speed_weight");
  options.acceleration_weight = section.nonNegative("acceleration_weight");
  options.lateral_weight = section.nonNegative("lateral_weight");
  options.heading_weight = section.nonNegative("heading_weight");
  options.steering_weight = section.nonNegative("steering_weight");
  options.steering_rate_weight = section.positive("steering_rate_weight");
  options.stop_speed = section.nonNegative("stop_speed");
  options.stop_gain = section.nonNegative("stop_gain");
  options.jerk_penalty = section.positive("jerk_penalty");
  options.curvature_rate_penalty = section.positive("curvature_rate_penalty");
}

static void readOptions(Section& section, RouteCenterlineOptions& options) {
  options.spacing = section.positive("spacing");
  options.route_lane_distance = section.nonNegative("route_lane_distance");
  options.route_lane_heading = section.angle("route_lane_heading");
  options.lane_change_cost = section.nonNegative("lane_change_cost");
  options.off_lane_cost = section.nonNegative("off_lane_cost");
  options.lane_change_length = section.nonNegative("lane_change_length");
}

static void readOptions(Section& section, IdmParameters& options) {
  options.min_gap = section.positive("min_gap");
  options.time_headway = section.nonNegative("time_headway");
  options.max_acceleration = section.positive("max_acceleration");
  options.braking = section.positive("braking");
  options.exponent = section.positive("exponent");
}

static void readOptions(Section& section, PdmMapOptions& options) {
  options.radius = section.positive("radius");
  options.lane_width = section.positive("lane_width");
  options.road_half_width = section.positive("road_half_width");
  options.road_heading = section.angle("road_heading");
  options.drivable_margin = section.nonNegative("drivable_margin");
}

static void readOptions(Section& section, PdmAgentOptions& options) {
  options.radius = section.positive("radius");
  options.vehicles = section.count("vehicles", 0);
  options.pedestrians = section.count("pedestrians", 0);
  options.bicycles = section.count("bicycles", 0);
  options.static_objects = section.count("static_objects", 0);
  options.standing_speed = section.nonNegative("standing_speed");
}

static void readOptions(Section& section, PdmComfortOptions& options) {
  options.jerk_window = section.count("jerk_window", 3);
  options.yaw_window = section.count("yaw_window", 4);
  options.max_jerk = section.positive("max_jerk");
  options.max_lateral_acceleration = section.positive("max_lateral_acceleration");
  options.max_longitudinal_acceleration = section.positive("max_longitudinal_acceleration");
  options.max_braking = section.positive("max_braking");
  options.max_yaw_acceleration = section.positive("max_yaw_acceleration");
  options.max_longitudinal_jerk = section.positive("max_longitudinal_jerk");
  options.max_yaw_rate = section.positive("max_yaw_rate");
}

static void readOptions(Section& section, PdmScoringOptions& options) {
  options.progress_weight = section.nonNegative("progress_weight");
  options.ttc_weight = section.nonNegative("ttc_weight");
  options.comfort_weight = section.positive("comfort_weight");
  options.static_collision_score = section.share("static_collision_score");
  options.min_progress = section.nonNegative("min_progress");
  options.ttc_times = section.numbers("ttc_times", 0.0, kMaxTtc);
  options.ahead_angle = section.angle("ahead_angle");
  options.behind_angle = section.angle("behind_angle", options.ahead_angle);
  options.standing_speed = section.nonNegative("standing_speed");
  options.ttc_standing_speed = section.nonNegative("ttc_standing_speed");
  options.wrong_way_distance = section.positive("wrong_way_distance");
  options.max_wrong_way_distance =
      section.atLeast("max_wrong_way_distance", options.wrong_way_distance);
  options.wrong_way_score = section.share("wrong_way_score");
  section.read("comfort", options.comfort);
}

static void readOptions(Section& section, PdmBrakeOptions& options) {
  options.max_time = section.nonNegative("max_time");
  options.max_speed = section.nonNegative("max_speed");
  options.standing_speed = section.nonNegative("standing_speed");
  options.gain = section.nonNegative("gain");
  options.overshoot = section.positive("overshoot");
  options.standing_gain = section.nonNegative("standing_gain");
  options.braking = section.positive("braking");
  options.max_acceleration = section.positive("max_acceleration");
}

static void readOptions(Section& section, PdmOptions& options, double step) {
  options.step = step;
  section.read("map", options.map);
  options.tracker_wheelbase = section.positive("tracker_wheelbase");
  options.speed_limit = section.positive("speed_limit");
  options.lateral_offsets = section.numbers("lateral_offsets", -kMaxOffset, kMaxOffset);
  options.speed_shares = section.positives("speed_shares");
  section.read("scoring", options.scoring);
  const PdmComfortOptions& comfort = options.scoring.comfort;
  options.proposal_steps =
      section.count("proposal_steps", std::max(comfort.jerk_window, comfort.yaw_window));
  options.output_steps = section.count("output_steps", options.proposal_steps);
  options.lead_interval = section.count("lead_interval", 1);
  section.read("idm", options.idm);
  section.read("agents", options.agents);
  section.read("emergency_brake", options.emergency_brake);
}

static void readOptions(Section& section, RouteOptions& options) {
  options.spacing = section.positive("spacing");
  options.length_ahead = section.positive("length_ahead");
  options.join_distance = section.positive("join_distance");
  options.end_lane_distance = section.nonNegative("end_lane_distance");
  options.end_lane_heading = section.angle("end_lane_heading");
}

static void readOptions(Section& section, PlanningOptions& options) {
  options.history = section.nonNegative("history");
  options.interval = section.atLeast("interval", kMinTimeStep);
  section.read("route", options.route);
}

static void readOptions(Section& section, IdmOptions& options) {
  options.law = readIdmLaw(section);
  options.lead.radius = section.positive("radius");
  options.lead.margin = section.nonNegative("margin");
  options.step = section.atLeast("step", kMinTimeStep);
  options.horizon = section.atLeast("horizon", options.step);
}

static void readOptions(Section& section, PublishedIdmOptions& options) {
  options.law = readIdmLaw(section);
  options.step = section.atLeast("step", kMinTimeStep);
  options.tolerance.relative_tolerance = section.positive("relative_tolerance");
  options.tolerance.absolute_tolerance = section.positive("absolute_tolerance");
}

static void readOptions(Section& section, ExternalOptions& options) {
  options.interval = section.atLeast("interval", kMinTimeStep);
  options.timeout = section.positive("timeout");
}

static void readOptions(Section& section, TorchscriptOptions& options) {
  options.file = section.path("file");
  options.device =
      section.choice<std::string>("device", {{"auto", "auto"}, {"cpu", "cpu"}, {"cuda", "cuda"}});
  options.interval = section.atLeast("interval", kMinTimeStep);
  options.timeout = section.positive("timeout");
  options.start_timeout = section.positive("start_timeout");
}

void readOptions(Section& file, PlannerOptions& options, const VehicleLimits& limits) {
  file.read("planning", options.planning);
  Section idm = file.section("idm");
  idm.read("standard", options.idm);
  idm.read("published", options.published_idm);
  idm.finish();
  file.read("external", options.external);
  file.read("car", options.car, limits);
  file.read("lqr", options.lqr);
  file.read("route_centerline", options.route_centerline);
  file.read("pdm", options.pdm, options.lqr.step);
  readRuleBased(file.section("rule_based"), options);
  file.read("torchscript", options.torchscript);
}

}  // namespace forge
