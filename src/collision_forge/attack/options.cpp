#include "collision_forge/attack/options.h"

#include "collision_forge/config/section.h"

namespace forge {

static void readOptions(Section& section, BicycleOptions& options) {
  options.iterations = section.count("iterations", 1);
  options.convergence = section.nonNegative("convergence");
  options.max_miss = section.positive("max_miss");
  options.turn_heading = section.nonNegative("turn_heading");
  options.position_scale = section.positive("position_scale");
  options.heading_scale = section.positive("heading_scale");
  options.speed_scale = section.positive("speed_scale");
  options.acceleration_scale = section.positive("acceleration_scale");
  options.curvature_scale = section.positive("curvature_scale");
}

static void readOptions(Section& section, SteeringOptions& options) {
  options.step = section.positive("step");
  options.first_population = section.count("first_population", 1);
  options.population = section.count("population", 1);
  options.elites = section.count("elites", 1);
  options.rounds = section.count("rounds", 0);
  options.considered = section.count("considered", 1);
  options.patience = section.count("patience", 1);
  options.hopeless = section.positive("hopeless");
  options.acceleration_deviation = section.positive("acceleration_deviation");
  options.curvature_deviation = section.positive("curvature_deviation");
  options.least_acceleration_deviation = section.nonNegative("least_acceleration_deviation");
  options.least_curvature_deviation = section.nonNegative("least_curvature_deviation");
  options.heading_weight = section.nonNegative("heading_weight");
  options.clearance = section.nonNegative("clearance");
  options.near = section.positive("near");
}

static void readOptions(Section& section, SearchOptions& options) {
  options.step = section.positive("step");
  options.tail = section.atLeast("tail", options.step);
  options.depth = section.nonNegative("depth");
  options.limit_margin = section.share("limit_margin");
  options.heading_margin = section.nonNegative("heading_margin");
  options.time_margin = section.positive("time_margin");
  options.overlap_margin = section.nonNegative("overlap_margin");
  options.max_attackers = section.count("max_attackers", 1);
  options.lane_paths = section.count("lane_paths", 0);
  options.ego_poses = section.count("ego_poses", 1);
  options.draws = section.count("draws", 1);
  options.homed = section.count("homed", 0);
  options.corrections = section.count("corrections", 0);
  options.max_lead = section.nonNegative("max_lead");
  options.kept = section.count("kept", 1);
  options.rounds = section.count("rounds", 0);
  options.perturbations = section.count("perturbations", 0);
  options.bicycle_targets = section.count("bicycle_targets", 0);
  options.bicycle_rounds = section.count("bicycle_rounds", 0);
  options.bicycle_perturbations = section.count("bicycle_perturbations", 0);
  options.good_share = section.share("good_share");
  options.good_off_road = section.share("good_off_road");
  options.good_steering = section.positive("good_steering");
  options.off_road_weight = section.nonNegative("off_road_weight");
  options.effort_weight = section.nonNegative("effort_weight");
  options.steering_weight = section.nonNegative("steering_weight");
  options.quick_steering = section.positive("quick_steering");
  options.closeness_weight = section.share("closeness_weight");
  options.pattern_weight = section.nonNegative("pattern_weight");
  options.near_pattern = section.positive("near_pattern");
  options.exact_distance = section.positive("exact_distance");
  options.exact_heading = section.positive("exact_heading");
  options.confidence_curve = section.risingShares("confidence_curve");
}

void readOptions(Section& section, NominalOptions& options) {
  options.end_distance = section.positive("end_distance");
  options.side_distance = section.positive("side_distance");
  options.lane_change_ahead = section.nonNegative("lane_change_ahead");
  options.lane_change_side = section.nonNegative("lane_change_side");
  options.lane_change_heading = section.angle("lane_change_heading");
}

void readOptions(Section& section, RequestListOptions& options) {
  options.stride = section.positive("stride");
  options.ttas = section.positives("ttas");
  options.min_ego_speed = section.nonNegative("min_ego_speed");
}

static void readOptions(Section& file, AttackOptions& options) {
  file.read("search", options.search);
  file.read("bicycle_family", options.bicycle);
  file.read("steering", options.steering);
}

void readAttackOptions(const std::string& directory, AttackOptions& options) {
  readConfigFile(directory, "prediction", options.prediction);
  readConfigFile(openConfigFile(directory, "search.yaml"), options);
  readConfigFile(directory, "verification", options.verification);
  readConfigFile(directory, "vehicle_limits", options.verification.limits);
  readConfigFile(directory, "ego_futures", options.ego_futures, options.prediction.step);
}

}  // namespace forge
