#include "collision_forge/config/planner_config.h"

#include "collision_forge/config/config_section.h"

#include <limits>

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMaxHeading = 3.1416;  // rad; pi as the file rounds it
constexpr double kMaxTtc = 60.0;        // s
constexpr double kMaxOffset = 10.0;     // m
constexpr double kMaxSpeedShare = 2.0;
constexpr double kMinTimeStep = 0.01;  // s; with shorter ones a test computes for minutes
constexpr double kMaxSteering = 1.5;   // rad; short of a wheel across the car

double readTimeStep(Section& section, const char* key) {
  return section.within(key, kMinTimeStep, kInfinity);
}

KinematicBicycleOptions readKinematicBicycle(Section section, const VehicleLimits& limits) {
  KinematicBicycleOptions options;
  options.wheelbase = section.positive("wheelbase");
  options.max_steering = section.within("max_steering", 0.0, kMaxSteering);
  options.max_acceleration = limits.max_forward_acceleration;
  options.max_braking = limits.max_braking;
  options.acceleration_lag = section.nonNegative("acceleration_lag");
  options.steering_lag = section.nonNegative("steering_lag");
  section.finish();
  return options;
}

LqrOptions readLqr(Section section) {
  LqrOptions options;
  options.step = readTimeStep(section, "step");
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
  section.finish();
  return options;
}

RouteCenterlineOptions readRouteCenterline(Section section) {
  RouteCenterlineOptions options;
  options.spacing = section.positive("spacing");
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxHeading);
  options.lane_change_cost = section.nonNegative("lane_change_cost");
  options.off_lane_cost = section.nonNegative("off_lane_cost");
  options.lane_change_length = section.nonNegative("lane_change_length");
  section.finish();
  return options;
}

IdmParameters readPdmIdm(Section section) {
  IdmParameters idm;
  idm.min_gap = section.positive("min_gap");
  idm.time_headway = section.nonNegative("time_headway");
  idm.max_acceleration = section.positive("max_acceleration");
  idm.braking = section.positive("braking");
  idm.exponent = section.positive("exponent");
  section.finish();
  return idm;
}

PdmAgentOptions readPdmAgents(Section section) {
  PdmAgentOptions options;
  options.vehicles = section.count("vehicles", 0);
  options.pedestrians = section.count("pedestrians", 0);
  options.bicycles = section.count("bicycles", 0);
  options.static_objects = section.count("static_objects", 0);
  options.standing_speed = section.nonNegative("standing_speed");
  section.finish();
  return options;
}

PdmComfortOptions readPdmComfort(Section section) {
  PdmComfortOptions options;
  options.window = section.count("window", 3);
  options.max_jerk = section.positive("max_jerk");
  options.max_lateral_acceleration = section.positive("max_lateral_acceleration");
  options.max_longitudinal_acceleration = section.positive("max_longitudinal_acceleration");
  options.max_braking = section.positive("max_braking");
  options.max_yaw_acceleration = section.positive("max_yaw_acceleration");
  options.max_longitudinal_jerk = section.positive("max_longitudinal_jerk");
  options.max_yaw_rate = section.positive("max_yaw_rate");
  section.finish();
  return options;
}

PdmScoringOptions readPdmScoring(Section section) {
  PdmScoringOptions options;
  options.progress_weight = section.nonNegative("progress_weight");
  options.ttc_weight = section.nonNegative("ttc_weight");
  options.comfort_weight = section.positive("comfort_weight");
  options.static_collision_score = section.within("static_collision_score", 0.0, 1.0);
  options.min_progress = section.nonNegative("min_progress");
  options.ttc_times = section.numbers("ttc_times", 0.0, kMaxTtc);
  options.ahead_angle = section.within("ahead_angle", 0.0, kMaxHeading);
  options.behind_angle = section.within("behind_angle", options.ahead_angle, kMaxHeading);
  options.standing_speed = section.nonNegative("standing_speed");
  options.wrong_way_time = section.positive("wrong_way_time");
  options.wrong_way_distance = section.positive("wrong_way_distance");
  options.max_wrong_way_distance =
      section.within("max_wrong_way_distance", options.wrong_way_distance, kInfinity);
  options.wrong_way_score = section.within("wrong_way_score", 0.0, 1.0);
  options.route_distance = section.nonNegative("route_distance");
  options.drivable_margin = section.nonNegative("drivable_margin");
  options.comfort = readPdmComfort(section.section("comfort"));
  section.finish();
  return options;
}

PdmBrakeOptions readPdmBrake(Section section) {
  PdmBrakeOptions options;
  options.max_time = section.nonNegative("max_time");
  options.max_speed = section.nonNegative("max_speed");
  options.braking = section.positive("braking");
  section.finish();
  return options;
}

PdmOptions readPdm(Section section, double step) {
  PdmOptions options;
  options.step = step;
  options.map_radius = section.positive("map_radius");
  options.speed_limit = section.positive("speed_limit");
  options.lateral_offsets = section.numbers("lateral_offsets", -kMaxOffset, kMaxOffset);
  options.speed_shares = section.positives("speed_shares");
  options.proposal_steps = section.count("proposal_steps", 2);
  options.output_steps = section.count("output_steps", options.proposal_steps);
  options.lead_interval = section.count("lead_interval", 1);
  options.idm = readPdmIdm(section.section("idm"));
  options.agents = readPdmAgents(section.section("agents"));
  options.scoring = readPdmScoring(section.section("scoring"));
  options.emergency_brake = readPdmBrake(section.section("emergency_brake"));
  section.finish();
  return options;
}

RouteOptions readRoute(Section section) {
  RouteOptions options;
  options.spacing = section.positive("spacing");
  options.length_ahead = section.positive("length_ahead");
  options.join_distance = section.positive("join_distance");
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxHeading);
  section.finish();
  return options;
}

PlanningOptions readPlanning(Section section) {
  PlanningOptions options;
  options.history = section.nonNegative("history");
  Section intervals = section.section("intervals");
  for (const char* planner : {"idm", "idm_published", "rule_based", "rule_based_tuned", "pdm"}) {
    options.intervals[planner] = readTimeStep(intervals, planner);
  }
  intervals.finish();
  options.route = readRoute(section.section("route"));
  section.finish();
  return options;
}

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

IdmOptions readIdm(Section section) {
  IdmOptions options;
  options.law = readIdmLaw(section);
  options.lead.radius = section.positive("radius");
  options.lead.margin = section.nonNegative("margin");
  options.step = readTimeStep(section, "step");
  options.horizon = section.within("horizon", options.step, kInfinity);
  section.finish();
  return options;
}

PublishedIdmOptions readPublishedIdm(Section section) {
  PublishedIdmOptions options;
  options.law = readIdmLaw(section);
  options.step = readTimeStep(section, "step");
  section.finish();
  return options;
}

ExternalOptions readExternal(Section section) {
  ExternalOptions options;
  options.interval = readTimeStep(section, "interval");
  options.timeout = section.positive("timeout");
  section.finish();
  return options;
}

RolloutOptions readRollout(Section section) {
  RolloutOptions options;
  options.step = readTimeStep(section, "step");
  options.hard_braking = section.positive("hard_braking");
  Section fault = section.section("fault");
  options.fault.standstill_speed = fault.nonNegative("standstill_speed");
  options.fault.behind_angle = fault.within("behind_angle", 0.0, kMaxHeading);
  options.fault.front_tolerance = fault.nonNegative("front_tolerance");
  options.fault.off_road_share = fault.within("off_road_share", 0.0, 1.0);
  options.fault.lane_radius = fault.nonNegative("lane_radius");
  fault.finish();
  section.finish();
  return options;
}

AvoidabilityOptions readAvoidability(Section section, const VehicleLimits& limits) {
  constexpr double kWidest = 20.0;  // m; no road is wider to either side
  AvoidabilityOptions options;
  options.interval = readTimeStep(section, "interval");
  options.step = readTimeStep(section, "step");
  options.accelerations =
      section.numbers("accelerations", -limits.max_braking, limits.max_forward_acceleration);
  options.offsets = section.numbers("offsets", -kWidest, kWidest);
  options.durations = section.numbers("durations", 0.0, kInfinity);
  options.return_time = section.positive("return_time");
  options.min_return_distance = section.positive("min_return_distance");
  options.margin = section.nonNegative("margin");
  options.draws = section.count("draws", 0);
  options.seed = static_cast<std::uint64_t>(section.count("seed", 0));
  section.finish();
  return options;
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
  options.step = readTimeStep(section, "step");
  options.steps = section.count("steps", 2);
  options.middle_speeds = section.count("middle_speeds", 1);
  options.end_speeds = section.count("end_speeds", 1);
  options.interaction_radius = section.nonNegative("interaction_radius");
  options.speed_shares = section.numbers("speed_shares", 0.0, kMaxSpeedShare);
  options.acceleration_share = section.positive("acceleration_share");
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxHeading);
  options.max_paths = section.count("max_paths", 1);
  options.bend_length = section.positive("bend_length");
  options.sample_spacing = section.positive("sample_spacing");
  options.circles = section.count("circles", 1);
  options.safety_buffer = section.nonNegative("safety_buffer");
  options.max_probability = section.within("max_probability", 0.0, 1.0);
  planners.rule_based = withParameters(options, section.section("published"));
  planners.tuned_rule_based = withParameters(options, section.section("tuned"));
  section.finish();
}

PlannerOptions readPlanners(Section file, const VehicleLimits& limits) {
  PlannerOptions options;
  options.planning = readPlanning(file.section("planning"));
  Section idm = file.section("idm");
  options.idm = readIdm(idm.section("standard"));
  options.published_idm = readPublishedIdm(idm.section("published"));
  idm.finish();
  options.external = readExternal(file.section("external"));
  options.rollout = readRollout(file.section("rollout"));
  options.avoidability = readAvoidability(file.section("avoidability"), limits);
  options.bicycle = readKinematicBicycle(file.section("bicycle"), limits);
  options.lqr = readLqr(file.section("lqr"));
  options.route_centerline = readRouteCenterline(file.section("route_centerline"));
  options.pdm = readPdm(file.section("pdm"), options.lqr.step);
  readRuleBased(file.section("rule_based"), options);
  file.finish();
  return options;
}

}  // namespace

PlannerOptions loadPlanners(const std::string& directory, const VehicleLimits& limits) {
  return readPlanners(openConfigFile(directory, "planners.yaml"), limits);
}

PlannerOptions parsePlanners(const std::string& path, const std::string& text,
                             const VehicleLimits& limits) {
  return readPlanners(openConfigText(path, text), limits);
}

}  // namespace forge
