#include "collision_forge/config/attack_config.h"

#include <filesystem>
#include <limits>

#include "collision_forge/config/config_section.h"

namespace forge {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kMaxHeading = 3.1416;   // rad; pi as the files round it
constexpr double kMaxLaneHeading = 1.5;  // rad; an ego that crosses a lane does not follow it

VehicleLimits loadVehicleLimits(const std::string& directory) {
  Section file = openConfigFile(directory, "vehicle_limits.yaml");
  Section section = file.section("vehicle_limits");
  VehicleLimits limits;
  limits.max_forward_acceleration = section.positive("max_forward_acceleration");
  limits.max_braking = section.positive("max_braking");
  limits.max_total_acceleration = section.positive("max_total_acceleration");
  limits.max_curvature = section.positive("max_curvature");
  limits.max_speed = section.positive("max_speed");
  limits.curvature_min_speed = section.nonNegative("curvature_min_speed");
  limits.heading_slack = section.nonNegative("heading_slack");
  limits.heading_per_metre = section.nonNegative("heading_per_metre");
  section.finish();
  file.finish();
  return limits;
}

void loadCollisionTypes(const std::string& directory, CrashDefinition& crash) {
  Section file = openConfigFile(directory, "collision_types.yaml");
  Section types = file.section("collision_types");
  crash.rules = types.typeRules("rules");
  for (const CollisionType type : kCollisionTypes) {
    Section section = types.section(toString(type));
    TypeDefinition& definition = crash.types[type];
    definition.min_heading = section.within("min_heading", 0.0, kMaxHeading);
    definition.max_heading = section.within("max_heading", definition.min_heading, kMaxHeading);
    definition.nominal_heading =
        section.within("nominal_heading", definition.min_heading, definition.max_heading);
    definition.min_approach = section.within("min_approach", 0.0, kMaxHeading);
    definition.max_approach = section.within("max_approach", definition.min_approach, kMaxHeading);
    section.finish();
  }
  types.finish();
  file.finish();
}

PredictionOptions loadPrediction(const std::string& directory) {
  Section file = openConfigFile(directory, "prediction.yaml");
  Section section = file.section("prediction");
  PredictionOptions options;
  options.history_frames = section.count("history_frames", 1);
  options.min_history_frames = section.count("min_history_frames", 1, options.history_frames);
  options.motion_frames = section.count("motion_frames", 2);
  options.min_tta = section.positive("min_tta");
  options.max_tta = section.within("max_tta", options.min_tta, kInfinity);
  options.candidate_radius = section.positive("candidate_radius");
  options.step = section.positive("step");
  options.tail = section.positive("tail");
  options.ego_samples = section.count("ego_samples", 2);
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxHeading);
  options.standstill_speed = section.nonNegative("standstill_speed");
  options.lane_return_distance = section.positive("lane_return_distance");
  options.rear_end_closing_speed = section.positive("rear_end_closing_speed");
  options.min_impact_speed = section.nonNegative("min_impact_speed");
  section.finish();
  file.finish();
  return options;
}

BicycleOptions readBicycle(Section section) {
  BicycleOptions options;
  options.iterations = section.count("iterations", 1);
  options.convergence = section.nonNegative("convergence");
  options.max_miss = section.positive("max_miss");
  options.turn_heading = section.nonNegative("turn_heading");
  options.position_scale = section.positive("position_scale");
  options.heading_scale = section.positive("heading_scale");
  options.speed_scale = section.positive("speed_scale");
  options.acceleration_scale = section.positive("acceleration_scale");
  options.curvature_scale = section.positive("curvature_scale");
  section.finish();
  return options;
}

SteeringOptions readSteering(Section section) {
  SteeringOptions options;
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
  section.finish();
  return options;
}

SearchOptions readSearch(Section section, CrashDefinition& crash) {
  SearchOptions options;
  options.step = section.positive("step");
  options.tail = section.within("tail", options.step, kInfinity);
  options.depth = section.nonNegative("depth");
  options.limit_margin = section.within("limit_margin", 0.0, 1.0);
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
  options.good_share = section.within("good_share", 0.0, 1.0);
  options.good_off_road = section.within("good_off_road", 0.0, 1.0);
  options.good_steering = section.positive("good_steering");
  options.off_road_weight = section.nonNegative("off_road_weight");
  options.effort_weight = section.nonNegative("effort_weight");
  options.steering_weight = section.nonNegative("steering_weight");
  options.quick_steering = section.positive("quick_steering");
  options.closeness_weight = section.within("closeness_weight", 0.0, 1.0);
  options.pattern_weight = section.nonNegative("pattern_weight");
  options.near_pattern = section.positive("near_pattern");
  options.exact_distance = section.positive("exact_distance");
  options.exact_heading = section.positive("exact_heading");
  options.confidence_curve = section.risingShares("confidence_curve");
  crash.min_confidence = section.within("min_confidence", 0.0, 1.0);
  section.finish();
  return options;
}

/// Attacks keep `time_margin` to the ends of the time tolerance.
VerificationOptions loadVerification(const std::string& directory, double time_margin,
                                     CrashDefinition& crash) {
  Section file = openConfigFile(directory, "verification.yaml");
  Section section = file.section("verification");
  VerificationOptions options;
  crash.time_tolerance = section.within("time_tolerance", time_margin, kInfinity);
  options.overlap_tolerance = section.positive("overlap_tolerance");
  options.off_road_interval = section.positive("off_road_interval");
  section.finish();
  file.finish();
  return options;
}

FeatureWeights readFeatureWeights(Section section) {
  const char* const features[kSpeedFeatures] = {
      "speed",     "acceleration", "acceleration_before", "acceleration_long_before",
      "turn_rate", "bend_braking", "bend_turn",           "bend_curvature",
      "headway",   "closing"};
  FeatureWeights weights = {};
  for (std::size_t i = 0; i < kSpeedFeatures; ++i) {
    weights[i] = section.nonNegative(features[i]);
  }
  section.finish();
  return weights;
}

SpeedModelFitOptions loadSpeedModelFit(const std::string& directory) {
  Section file = openConfigFile(directory, "speed_model_fit.yaml");
  Section section = file.section("speed_model_fit");
  SpeedModelFitOptions options;
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
  options.feature_weights = readFeatureWeights(section.section("feature_weights"));
  section.finish();
  file.finish();
  return options;
}

SpeedProfileOptions readSpeedProfiles(Section section) {
  SpeedProfileOptions options;
  options.neighbors = section.count("neighbors", 1);
  options.ridge = section.positive("ridge");
  options.residual_scale = section.nonNegative("residual_scale");
  options.feature_weights = readFeatureWeights(section.section("feature_weights"));
  section.finish();
  return options;
}

EgoPathOptions readEgoPaths(Section section) {
  EgoPathOptions options;
  options.lane_max_distance = section.nonNegative("lane_max_distance");
  options.lane_max_heading = section.within("lane_max_heading", 0.0, kMaxLaneHeading);
  options.max_lanes = section.count("max_lanes", 0);
  options.max_paths_per_lane = section.count("max_paths_per_lane", 1);
  options.near_deviation_cost = section.nonNegative("near_deviation_cost");
  options.far_deviation_cost = section.nonNegative("far_deviation_cost");
  options.bend_braking_cost = section.nonNegative("bend_braking_cost");
  options.turn_cost = section.nonNegative("turn_cost");
  options.free_path_cost = section.nonNegative("free_path_cost");
  options.comfortable_lateral_acceleration = section.positive("comfortable_lateral_acceleration");
  options.turn_rate_fading = section.positive("turn_rate_fading");
  section.finish();
  return options;
}

EgoFutureOptions readEgoFutures(Section section) {
  EgoFutureOptions options;
  options.step = section.positive("step");
  options.paths = readEgoPaths(section.section("paths"));
  options.speed = readSpeedProfiles(section.section("speed"));
  Section lateral = section.section("lateral");
  options.lane_return_time = lateral.positive("lane_return_time");
  options.lane_return_min_distance = lateral.positive("lane_return_min_distance");
  options.kept_offset = lateral.within("kept_offset", 0.0, 1.0);
  options.offset_spread = lateral.nonNegative("offset_spread");
  options.turn_rate_spread = lateral.nonNegative("turn_rate_spread");
  lateral.finish();
  Section no_profiles = section.section("no_profiles");
  options.acceleration_fading = no_profiles.positive("acceleration_fading");
  options.acceleration_spread = no_profiles.nonNegative("acceleration_spread");
  no_profiles.finish();
  section.finish();
  return options;
}

void loadSearch(const std::string& directory, AttackOptions& options, CrashDefinition& crash) {
  Section file = openConfigFile(directory, "search.yaml");
  options.search = readSearch(file.section("search"), crash);
  options.bicycle = readBicycle(file.section("bicycle"));
  options.steering = readSteering(file.section("steering"));
  file.finish();
}

void loadEgoFutures(const std::string& directory, Config& config) {
  Section file = openConfigFile(directory, "ego_futures.yaml");
  config.attack.ego_futures = readEgoFutures(file.section("ego_futures"));
  const std::string profiles = file.text("speed_profiles");
  if (!profiles.empty()) config.speed_profiles = std::filesystem::path(directory) / profiles;
  const std::string model = file.text("speed_model");
  if (!model.empty()) config.speed_model = std::filesystem::path(directory) / model;
  file.finish();
}

}  // namespace

void loadAttack(const std::string& directory, Config& config) {
  loadCollisionTypes(directory, config.crash);
  config.attack.prediction = loadPrediction(directory);
  loadSearch(directory, config.attack, config.crash);
  config.attack.verification =
      loadVerification(directory, config.attack.search.time_margin, config.crash);
  config.attack.verification.limits = loadVehicleLimits(directory);
  loadEgoFutures(directory, config);
  config.speed_model_fit = loadSpeedModelFit(directory);
}

}  // namespace forge
