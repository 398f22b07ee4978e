#include <gtest/gtest.h>

#include <array>

#include "collision_forge/config/config.h"

namespace forge {
namespace {

const char* const kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

TEST(ShippedConfig, DatasetHasTheDocumentedValues) {
  const DatasetOptions options = loadConfig(kShipped).dataset;
  EXPECT_EQ(options.begin_stride, 0.5);
  EXPECT_EQ(options.min_length, 4.5);
  EXPECT_EQ(options.max_length, 9.0);
  EXPECT_EQ(options.attempts.size(), 5U);
  EXPECT_EQ(options.attempts.at(CollisionType::kOppositeDirection), 5);
  EXPECT_EQ(options.time_tolerance, 0.1);
  EXPECT_EQ(options.balance.min_type_share, 0.15);
  EXPECT_EQ(options.split.train_share, 0.7);
  EXPECT_EQ(options.split.val_share, 0.1);
}

TEST(ShippedConfig, LimitsAndVehicleHaveTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  const VehicleLimits& limits = config.attack.verification.limits;
  EXPECT_EQ(limits.max_forward_acceleration, 5.0);
  EXPECT_EQ(limits.max_braking, 8.0);
  EXPECT_EQ(limits.max_total_acceleration, 8.0);
  EXPECT_EQ(limits.max_curvature, 0.2);
  EXPECT_EQ(limits.max_speed, 25.0);
  EXPECT_EQ(limits.curvature_min_speed, 2.0);
  EXPECT_EQ(limits.heading_slack, 0.1745);
  EXPECT_EQ(limits.heading_per_metre, 0.3);
  EXPECT_EQ(config.ego_vehicle.size.length, 4.084);
  EXPECT_EQ(config.ego_vehicle.size.width, 1.730);
  EXPECT_EQ(config.ego_vehicle.center_offset, 1.385);
}

TEST(ShippedConfig, PredictionAndEncodingHaveTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  const PredictionOptions& prediction = config.attack.prediction;
  EXPECT_EQ(prediction.history_frames, 8);
  EXPECT_EQ(prediction.min_history_frames, 2);
  EXPECT_EQ(prediction.motion_frames, 4);
  EXPECT_EQ(prediction.min_tta, 0.5);
  EXPECT_EQ(prediction.max_tta, 9.0);
  EXPECT_EQ(prediction.candidate_radius, 80.0);
  EXPECT_EQ(prediction.step, 0.1);
  EXPECT_EQ(prediction.tail, 2.0);
  EXPECT_EQ(prediction.ego_samples, 128);
  EXPECT_EQ(prediction.lane_max_distance, 2.0);
  EXPECT_EQ(prediction.lane_max_heading, 0.7854);
  EXPECT_EQ(prediction.standstill_speed, 0.5);
  EXPECT_EQ(prediction.lane_return_distance, 15.0);
  EXPECT_EQ(prediction.rear_end_closing_speed, 4.0);
  EXPECT_EQ(prediction.min_impact_speed, 3.0);
  EXPECT_EQ(config.encoding.lane_radius, 60.0);
  EXPECT_EQ(config.encoding.max_lanes, 128);
  EXPECT_EQ(config.encoding.lane_points, 20);
  EXPECT_EQ(config.encoding.lane_point_spacing, 2.0);
}

TEST(ShippedConfig, KinematicBicycleHasTheDocumentedValues) {
  const KinematicBicycleOptions& bicycle = loadConfig(kShipped).planners.bicycle;
  EXPECT_EQ(bicycle.wheelbase, 2.588);
  EXPECT_EQ(bicycle.max_steering, 1.0472);
  EXPECT_EQ(bicycle.acceleration_lag, 0.2);
  EXPECT_EQ(bicycle.steering_lag, 0.05);
  EXPECT_EQ(bicycle.max_acceleration, 5.0);
  EXPECT_EQ(bicycle.max_braking, 8.0);
}

TEST(ShippedConfig, PlanningAndIdmHaveTheDocumentedValues) {
  const PlannerOptions planners = loadConfig(kShipped).planners;
  EXPECT_EQ(planners.planning.history, 2.0);
  EXPECT_EQ(planners.planning.intervals, (std::map<std::string, double>{{"idm", 0.1},
                                                                        {"idm_published", 0.1},
                                                                        {"rule_based", 0.2},
                                                                        {"rule_based_tuned", 0.2},
                                                                        {"pdm", 0.1}}));
  EXPECT_EQ(planners.planning.route.spacing, 1.0);
  EXPECT_EQ(planners.planning.route.length_ahead, 100.0);
  EXPECT_EQ(planners.planning.route.join_distance, 5.0);
  EXPECT_EQ(planners.planning.route.lane_max_distance, 3.0);
  EXPECT_EQ(planners.planning.route.lane_max_heading, 0.785);
  const auto values = [](const IdmParameters& law) {
    return std::vector<double>{law.desired_speed, law.time_headway, law.max_acceleration,
                               law.braking,       law.min_gap,      law.exponent};
  };
  EXPECT_EQ(values(planners.idm.law), (std::vector<double>{10.0, 1.5, 1.0, 3.0, 1.0, 4.0}));
  EXPECT_EQ(values(planners.published_idm.law),
            (std::vector<double>{5.0, 1.5, 5.0, 2.0, 2.0, 4.0}));
  EXPECT_EQ(planners.idm.lead.radius, 40.0);
  EXPECT_EQ(planners.idm.lead.margin, 0.0);
  EXPECT_EQ(planners.idm.horizon, 8.0);
  EXPECT_EQ(planners.idm.step, 0.1);
  EXPECT_EQ(planners.published_idm.step, 0.1);
}

TEST(ShippedConfig, RolloutAndAvoidabilityHaveTheDocumentedValues) {
  const PlannerOptions planners = loadConfig(kShipped).planners;
  EXPECT_EQ(planners.external.interval, 0.1);
  EXPECT_EQ(planners.external.timeout, 2.0);
  EXPECT_EQ(planners.rollout.step, 0.1);
  EXPECT_EQ(planners.rollout.hard_braking, 4.05);
  EXPECT_EQ(planners.rollout.fault.standstill_speed, 0.05);
  EXPECT_EQ(planners.rollout.fault.behind_angle, 2.618);
  EXPECT_EQ(planners.rollout.fault.front_tolerance, 0.01);
  EXPECT_EQ(planners.rollout.fault.off_road_share, 0.05);
  EXPECT_EQ(planners.rollout.fault.lane_radius, 15.0);
  const AvoidabilityOptions& avoidability = planners.avoidability;
  EXPECT_EQ(avoidability.interval, 0.5);
  EXPECT_EQ(avoidability.step, 0.1);
  EXPECT_EQ(avoidability.accelerations,
            (std::vector<double>{0.0, -2.0, -4.0, -6.0, -7.9, 2.5, 5.0}));
  EXPECT_EQ(avoidability.offsets, (std::vector<double>{0.0, 1.0, -1.0, 2.0, -2.0, 3.5, -3.5}));
  EXPECT_EQ(avoidability.durations, (std::vector<double>{1.0, 2.0, 20.0}));
  EXPECT_EQ(avoidability.return_time, 0.4);
  EXPECT_EQ(avoidability.min_return_distance, 3.0);
  EXPECT_EQ(avoidability.margin, 0.1);
  EXPECT_EQ(avoidability.draws, 150);
  EXPECT_EQ(avoidability.seed, 1u);
}

TEST(ShippedConfig, LqrHasTheDocumentedValues) {
  const LqrOptions& lqr = loadConfig(kShipped).planners.lqr;
  EXPECT_EQ(lqr.step, 0.1);
  EXPECT_EQ(lqr.horizon, 10);
  EXPECT_EQ(lqr.speed_weight, 10.0);
  EXPECT_EQ(lqr.acceleration_weight, 1.0);
  EXPECT_EQ(lqr.lateral_weight, 1.0);
  EXPECT_EQ(lqr.heading_weight, 10.0);
  EXPECT_EQ(lqr.steering_weight, 0.0);
  EXPECT_EQ(lqr.steering_rate_weight, 1.0);
  EXPECT_EQ(lqr.stop_speed, 0.2);
  EXPECT_EQ(lqr.stop_gain, 0.5);
  EXPECT_EQ(lqr.jerk_penalty, 1e-4);
  EXPECT_EQ(lqr.curvature_rate_penalty, 1e-2);
}

TEST(ShippedConfig, PdmHasTheDocumentedValues) {
  const PdmOptions pdm = loadConfig(kShipped).planners.pdm;
  EXPECT_EQ(pdm.map_radius, 50.0);
  EXPECT_EQ(pdm.speed_limit, 15.0);
  EXPECT_EQ(pdm.lateral_offsets, (std::vector<double>{0.0, -1.0, 1.0}));
  EXPECT_EQ(pdm.speed_shares, (std::vector<double>{0.2, 0.4, 0.6, 0.8, 1.0}));
  EXPECT_EQ(pdm.step * pdm.proposal_steps, 4.0);
  EXPECT_EQ(pdm.step * pdm.output_steps, 8.0);
  EXPECT_EQ(pdm.idm.min_gap, 1.0);
  EXPECT_EQ(pdm.idm.max_acceleration, 1.5);
  EXPECT_EQ(pdm.idm.exponent, 10.0);
  EXPECT_EQ(pdm.agents.vehicles, 50);
  EXPECT_EQ(pdm.agents.static_objects, 50);
  EXPECT_EQ(pdm.scoring.progress_weight, 5.0);
  EXPECT_EQ(pdm.scoring.ttc_weight, 5.0);
  EXPECT_EQ(pdm.scoring.comfort_weight, 2.0);
  EXPECT_EQ(pdm.scoring.ttc_times, (std::vector<double>{0.0, 0.3, 0.6, 0.9}));
  EXPECT_EQ(pdm.scoring.comfort.max_jerk, 8.37);
  EXPECT_EQ(pdm.scoring.comfort.max_braking, 4.05);
  EXPECT_EQ(pdm.emergency_brake.max_time, 2.0);
  EXPECT_EQ(pdm.emergency_brake.max_speed, 5.0);
}

TEST(ShippedConfig, RuleBasedHasTheDocumentedValues) {
  const PlannerOptions planners = loadConfig(kShipped).planners;
  const RuleBasedOptions& published = planners.rule_based;
  const RuleBasedOptions& tuned = planners.tuned_rule_based;
  EXPECT_EQ(published.max_speed, 15.0);
  EXPECT_EQ(published.max_acceleration, 3.0);
  EXPECT_EQ(published.distance_weight, 0.7);
  EXPECT_EQ(published.distance_weight_rate, 0.05);
  EXPECT_EQ(tuned.max_speed, 20.0);
  EXPECT_EQ(tuned.max_acceleration, 4.0);
  EXPECT_EQ(tuned.distance_weight, 0.3);
  EXPECT_EQ(tuned.distance_weight_rate, 0.02);
  EXPECT_EQ(tuned.steps, 25);
  EXPECT_EQ(tuned.step, 0.2);
  EXPECT_EQ(tuned.interaction_radius, 70.0);
  EXPECT_EQ(tuned.bend_length, 3.5);
  EXPECT_EQ(tuned.safety_buffer, 4.0);
  EXPECT_EQ(tuned.max_probability, 0.1);
}

TEST(ShippedConfig, RequestListHasTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  EXPECT_EQ(config.requests.stride, 2.0);
  EXPECT_EQ(config.requests.ttas, (std::vector<double>{2.0, 3.0, 4.0, 5.0, 6.0}));
  EXPECT_EQ(config.requests.min_ego_speed, 2.0);
}

TEST(ShippedConfig, SearchHasTheDocumentedValues) {
  const SearchOptions search = loadConfig(kShipped).attack.search;
  EXPECT_EQ(search.step, 0.1);
  EXPECT_EQ(search.tail, 2.0);
  EXPECT_EQ(search.depth, 0.25);
  EXPECT_EQ(search.limit_margin, 0.998);
  EXPECT_EQ(search.heading_margin, 0.0087);
  EXPECT_EQ(search.time_margin, 0.03);
  EXPECT_EQ(search.overlap_margin, 0.04);
  EXPECT_EQ(search.max_attackers, 16);
  EXPECT_EQ(search.lane_paths, 3);
  EXPECT_EQ(search.ego_poses, 3);
  EXPECT_EQ(search.draws, 8);
  EXPECT_EQ(search.max_lead, 0.6);
  EXPECT_EQ(search.kept, 10);
  EXPECT_EQ(search.rounds, 4);
  EXPECT_EQ(search.perturbations, 60);
  EXPECT_EQ(search.bicycle_targets, 40);
  EXPECT_EQ(search.bicycle_rounds, 6);
  EXPECT_EQ(search.bicycle_perturbations, 100);
  EXPECT_EQ(search.good_share, 0.9);
  EXPECT_EQ(search.good_off_road, 0.05);
  EXPECT_EQ(search.off_road_weight, 0.4);
  EXPECT_EQ(search.effort_weight, 0.02);
  EXPECT_EQ(search.steering_weight, 0.3);
  EXPECT_EQ(search.quick_steering, 0.3);
  EXPECT_EQ(search.good_steering, 0.6);
  EXPECT_EQ(search.closeness_weight, 0.2);
  EXPECT_EQ(loadConfig(kShipped).crash.min_confidence, 0.05);
}

TEST(ShippedConfig, BicycleHasTheDocumentedValues) {
  const BicycleOptions bicycle = loadConfig(kShipped).attack.bicycle;
  EXPECT_EQ(bicycle.iterations, 12);
  EXPECT_EQ(bicycle.convergence, 0.02);
  EXPECT_EQ(bicycle.max_miss, 1.0);
  EXPECT_EQ(bicycle.turn_heading, 0.8);
  EXPECT_EQ(bicycle.position_scale, 0.1);
  EXPECT_EQ(bicycle.heading_scale, 0.03);
  EXPECT_EQ(bicycle.speed_scale, 3.0);
  EXPECT_EQ(bicycle.acceleration_scale, 40.0);
  EXPECT_EQ(bicycle.curvature_scale, 1.0);
}

TEST(ShippedConfig, SteeringHasTheDocumentedValues) {
  const SteeringOptions steering = loadConfig(kShipped).attack.steering;
  EXPECT_EQ(steering.step, 0.1);
  EXPECT_EQ(steering.first_population, 3008);
  EXPECT_EQ(steering.population, 704);
  EXPECT_EQ(steering.elites, 30);
  EXPECT_EQ(steering.rounds, 9);
  EXPECT_EQ(steering.considered, 20);
  EXPECT_EQ(steering.patience, 2);
  EXPECT_EQ(steering.hopeless, 5.0);
  EXPECT_EQ(steering.acceleration_deviation, 4.0);
  EXPECT_EQ(steering.curvature_deviation, 0.3);
  EXPECT_EQ(steering.least_acceleration_deviation, 0.05);
  EXPECT_EQ(steering.least_curvature_deviation, 0.001);
  EXPECT_EQ(steering.heading_weight, 8.0);
  EXPECT_EQ(steering.clearance, 0.4);
  EXPECT_EQ(steering.near, 0.8);
}

TEST(ShippedConfig, VerificationHasTheDocumentedValues) {
  const VerificationOptions verification = loadConfig(kShipped).attack.verification;
  EXPECT_EQ(loadConfig(kShipped).crash.time_tolerance, 0.5);
  EXPECT_EQ(verification.overlap_tolerance, 0.001);
  EXPECT_EQ(verification.off_road_interval, 0.5);
}

TEST(ShippedConfig, TypeRulesAreTheFullOnes) {
  EXPECT_EQ(loadConfig(kShipped).crash.rules, TypeRules::kFull);
}

TEST(ShippedConfig, EvaluationHasTheDocumentedValues) {
  const EvaluationOptions options = loadConfig(kShipped).evaluation;
  for (const BoxSize& box : {options.collide.box, options.published.box}) {
    EXPECT_EQ(box.length, 4.7);
    EXPECT_EQ(box.width, 2.0);
  }
  EXPECT_EQ(options.collide.tail, 2.0);
  EXPECT_EQ(options.collide.held_out_share, 0.1);
  EXPECT_EQ(options.published.min_overlap, 0.02);
  EXPECT_EQ(options.published.steps_per_interval, 5);
  EXPECT_EQ(options.published.steps_after, 20);
  EXPECT_NEAR(options.published.similar_heading, 10.0 * M_PI / 180.0, 1e-9);
  EXPECT_EQ(options.nominal.end_distance, 4.0);
  EXPECT_EQ(options.nominal.side_distance, 3.0);
  EXPECT_EQ(options.nominal.lane_change_ahead, 2.0);
  EXPECT_EQ(options.nominal.lane_change_side, 1.0);
  EXPECT_NEAR(options.nominal.lane_change_heading, 20.0 * M_PI / 180.0, 1e-4);
  EXPECT_EQ(options.published_search.heading_tolerance, 0.12);
  EXPECT_EQ(options.published_search.latest, 1.0);
  EXPECT_EQ(options.published_search.overlap_margin, 0.15);
  EXPECT_EQ(options.published_search.max_lead, 1.0);
  EXPECT_EQ(options.published_search.max_speed, 40.0);
  EXPECT_EQ(options.published_search.kept, 80);
  EXPECT_EQ(options.published_search.futures, 32);
  EXPECT_EQ(options.statistics.resamples, 1000);
  EXPECT_EQ(options.statistics.confidence, 0.95);
  EXPECT_EQ(options.statistics.seed, 1u);
}

TEST(ShippedConfig, SpeedModelFitHasTheDocumentedValues) {
  const SpeedModelFitOptions options = loadConfig(kShipped).speed_model_fit;
  EXPECT_EQ(options.intervals, 18);
  EXPECT_EQ(options.centers, 400);
  EXPECT_EQ(options.cluster_rounds, 20);
  EXPECT_EQ(options.folds, 5);
  EXPECT_EQ(options.gain_ridge, 0.1);
  EXPECT_EQ(options.spread_ridge, 30.0);
  EXPECT_EQ(options.linear_ridge, 10.0);
  EXPECT_EQ(options.spread_floor, 0.2);
  EXPECT_EQ(options.profiles, 128);
  EXPECT_EQ(options.standing_speed, 0.1);
  EXPECT_EQ(options.standing_profiles, 32);
  EXPECT_EQ(options.standing_ridge, 3.0);
  EXPECT_EQ(options.feature_weights,
            (FeatureWeights{0.25, 1.0, 0.75, 0.25, 2.5, 0.35, 1.14, 1.3, 0.25, 4.0}));
}

TEST(ShippedConfig, TrainingHasTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  const PatternFeatureOptions& features = config.pattern_features;
  EXPECT_EQ(features.head, EgoHead::kRegionProposal);
  EXPECT_EQ(features.history_frames, 8);
  EXPECT_EQ(features.agent_frames, 1);
  EXPECT_EQ(features.max_agents, 16);
  EXPECT_EQ(features.encoding.lane_radius, 60.0);
  EXPECT_EQ(features.encoding.max_lanes, 24);
  EXPECT_EQ(features.encoding.lane_points, 10);
  EXPECT_EQ(features.encoding.lane_point_spacing, 4.0);
  EXPECT_EQ(features.max_ways, 6);
  EXPECT_EQ(features.way_anchors, 25);
  EXPECT_EQ(features.spacing_floor, 0.03);
  EXPECT_EQ(features.spacing_rate, 0.2);
  EXPECT_EQ(features.spacing_exponent, 1.6);
  EXPECT_EQ(features.target_lanes, 24);
  EXPECT_EQ(features.target_points, 16);
  EXPECT_EQ(features.target_spacing, 3.0);
  EXPECT_EQ(config.pattern_layers.hidden, 32);
  EXPECT_EQ(config.pattern_layers.scene, 64);
  EXPECT_EQ(config.pattern_layers.anchor, 32);
  const TrainingOptions& training = config.training;
  EXPECT_EQ(training.epochs, 8);
  EXPECT_EQ(training.batch, 64);
  EXPECT_EQ(training.times, 4);
  EXPECT_EQ(training.learning_rate, 0.002);
  EXPECT_EQ(training.weight_decay, 0.01);
  EXPECT_EQ(training.dropout, 0.15);
  EXPECT_EQ(training.context_dropout, 0.4);
  EXPECT_EQ(training.max_gradient, 5.0);
  EXPECT_EQ(training.heading_weight, 5.0);
  EXPECT_EQ(training.offset_weight, 3.0);
  EXPECT_EQ(training.selection_weight, 0.3);
  EXPECT_EQ(training.clip_weight, 2.0);
  EXPECT_EQ(training.hidden_history_share, 0.3);
  EXPECT_EQ(training.mirrored_share, 0.5);
  EXPECT_EQ(training.validation_share, 0.1);
  EXPECT_EQ(training.max_tta, 9.0);
  EXPECT_EQ(training.min_vehicle_speed, 1.0);
  EXPECT_EQ(training.vehicle_stride, 1.0);
  EXPECT_EQ(training.noise_along, 0.3);
  EXPECT_EQ(training.noise_along_exponent, 1.4);
  EXPECT_EQ(training.noise_across, 0.1);
}

TEST(ShippedConfig, EgoFuturesHaveTheDocumentedValues) {
  const EgoFutureOptions options = loadConfig(kShipped).attack.ego_futures;
  EXPECT_EQ(options.step, 0.1);
  EXPECT_EQ(options.paths.lane_max_distance, 4.5);
  EXPECT_EQ(options.paths.lane_max_heading, 1.0);
  EXPECT_EQ(options.paths.max_lanes, 8);
  EXPECT_EQ(options.paths.max_paths_per_lane, 12);
  EXPECT_EQ(options.paths.near_deviation_cost, 1.1);
  EXPECT_EQ(options.paths.far_deviation_cost, 1.05);
  EXPECT_EQ(options.paths.bend_braking_cost, 3.3);
  EXPECT_EQ(options.paths.turn_cost, 0.53);
  EXPECT_EQ(options.paths.free_path_cost, 5.0);
  EXPECT_EQ(options.paths.comfortable_lateral_acceleration, 2.5);
  EXPECT_EQ(options.paths.turn_rate_fading, 2.3);
  EXPECT_EQ(options.speed.neighbors, 300);
  EXPECT_EQ(options.speed.ridge, 10.0);
  EXPECT_EQ(options.speed.residual_scale, 1.08);
  EXPECT_EQ(options.speed.feature_weights,
            (FeatureWeights{1.0, 1.0, 1.0, 0.5, 5.0, 0.7, 2.27, 2.6, 0.0, 22.8}));
  EXPECT_EQ(options.lane_return_time, 1.1);
  EXPECT_EQ(options.lane_return_min_distance, 5.0);
  EXPECT_EQ(options.kept_offset, 0.3);
  EXPECT_EQ(options.offset_spread, 0.28);
  EXPECT_EQ(options.turn_rate_spread, 0.04);
  EXPECT_EQ(options.acceleration_fading, 1.0);
  EXPECT_EQ(options.acceleration_spread, 1.2);
}

TEST(ShippedConfig, CollisionTypesHaveTheDocumentedBands) {
  const TypeDefinitions types = loadConfig(kShipped).crash.types;
  ASSERT_EQ(types.size(), 5u);
  const auto expect_bands = [&](CollisionType type, const std::array<double, 5>& values) {
    EXPECT_EQ(types.at(type).min_heading, values[0]) << toString(type);
    EXPECT_EQ(types.at(type).max_heading, values[1]) << toString(type);
    EXPECT_EQ(types.at(type).nominal_heading, values[2]) << toString(type);
    EXPECT_EQ(types.at(type).min_approach, values[3]) << toString(type);
    EXPECT_EQ(types.at(type).max_approach, values[4]) << toString(type);
  };
  expect_bands(CollisionType::kLaneChange, {0.1745, 0.5236, 0.2618, 0.0, 3.1416});
  expect_bands(CollisionType::kOppositeDirection, {2.9671, 3.1416, 3.1416, 0.0, 3.1416});
  expect_bands(CollisionType::kRearEnd, {0.0, 0.1745, 0.0, 0.0, 3.1416});
  expect_bands(CollisionType::kJunctionCrossing, {1.3963, 1.7453, 1.5708, 0.7854, 2.3562});
  expect_bands(CollisionType::kLtap, {1.3963, 1.7453, 1.5708, 2.3562, 3.1416});
}

TEST(ShippedConfig, ConversionAndDrawingHaveTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  EXPECT_EQ(config.conversion.map_radius, 150.0);
  EXPECT_EQ(config.conversion.centerline_resolution, 1.0);
  EXPECT_EQ(config.drawing.png_width, 900);
  EXPECT_EQ(config.drawing.chart_width, 1200);
  EXPECT_EQ(config.drawing.chart_height, 420);
  EXPECT_EQ(config.drawing.plot_size, 560);
  EXPECT_EQ(config.drawing.gif_font_size, 10.5);
  EXPECT_EQ(config.drawing.ghost_opacity, 0.22);
  EXPECT_EQ(config.drawing.attacker_color.red, 0.84);
  EXPECT_EQ(config.drawing.attacker_color.green, 0.15);
  EXPECT_EQ(config.drawing.attacker_color.blue, 0.16);
}

TEST(DrivingSide, IsThatOfTheLocationsPrefix) {
  const Config config = loadConfig(kShipped);
  EXPECT_EQ(drivingSide(config, "boston-seaport"), DrivingSide::kRight);
  EXPECT_EQ(drivingSide(config, "singapore-onenorth"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "singapore"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "embedded-left"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "embedded-right-2"), DrivingSide::kRight);
}

TEST(DrivingSide, TheLongestFittingPrefixDecides) {
  Config config;
  config.locations = {{"a", DrivingSide::kRight}, {"a-b", DrivingSide::kLeft}};
  EXPECT_EQ(drivingSide(config, "a-b-c"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "a-c"), DrivingSide::kRight);
}

TEST(DrivingSide, LocationsWithoutAFittingPrefixAreRefusedByName) {
  const Config config = loadConfig(kShipped);
  for (const char* location : {"las_vegas", "bost", ""}) {
    try {
      drivingSide(config, location);
      ADD_FAILURE() << location;
    } catch (const ConfigError& error) {
      EXPECT_NE(std::string(error.what()).find(location), std::string::npos);
      EXPECT_NE(std::string(error.what()).find("locations"), std::string::npos);
    }
  }
}

}  // namespace
}  // namespace forge
