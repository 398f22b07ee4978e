#include "formats/config.h"

#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <sstream>

namespace forge {
namespace {

namespace fs = std::filesystem;

const char* const kShipped = COLLISION_FORGE_SOURCE_DIR "/config";

/// A copy of the shipped files that a test may spoil; removed with the test.
class SpoiltConfig : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    directory_ = fs::path(testing::TempDir()) / (std::string("config_test_") + test->name());
    restore();
  }
  void TearDown() override { fs::remove_all(directory_); }

  void restore() const {
    fs::remove_all(directory_);
    fs::create_directories(directory_);
    for (const auto& entry : fs::directory_iterator(kShipped)) {
      fs::copy(entry.path(), directory_ / entry.path().filename());
    }
  }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(directory_ / file) << text;
  }

  /// Replaces the first `from` in a fresh copy of a file.
  void replace(const std::string& file, const std::string& from, const std::string& to) const {
    restore();
    std::stringstream content;
    content << std::ifstream(directory_ / file).rdbuf();
    std::string text = content.str();
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from << " is not in " << file;
    write(file, text.replace(at, from.size(), to));
  }

  /// What loading says; empty when it succeeds.
  std::string complaint() const {
    try {
      loadConfig(directory_.string());
    } catch (const ConfigError& error) {
      return error.what();
    }
    return "";
  }

  /// The complaint about a file after a replacement names all of `parts`.
  void expectComplaint(const std::string& file, const std::string& from, const std::string& to,
                       const std::vector<std::string>& parts) const {
    replace(file, from, to);
    const std::string text = complaint();
    EXPECT_NE(text.find(file), std::string::npos) << to << ": \"" << text << "\"";
    for (const std::string& part : parts) {
      EXPECT_NE(text.find(part), std::string::npos) << part << " in \"" << text << "\"";
    }
  }

  fs::path directory_;
};

TEST(Config, ShippedDatasetHasTheDocumentedValues) {
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

TEST(Config, ShippedLimitsAndVehicleHaveTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  const VehicleLimits& limits = config.attack.vehicle_limits;
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

TEST(Config, ShippedPredictionAndEncodingHaveTheDocumentedValues) {
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

TEST(Config, ShippedKinematicBicycleHasTheDocumentedValues) {
  const KinematicBicycleOptions& bicycle = loadConfig(kShipped).planners.bicycle;
  EXPECT_EQ(bicycle.wheelbase, 2.588);
  EXPECT_EQ(bicycle.max_steering, 1.0472);
  EXPECT_EQ(bicycle.acceleration_lag, 0.2);
  EXPECT_EQ(bicycle.steering_lag, 0.05);
  EXPECT_EQ(bicycle.max_acceleration, 5.0);
  EXPECT_EQ(bicycle.max_braking, 8.0);
}

TEST(Config, ShippedPlanningAndIdmHaveTheDocumentedValues) {
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

TEST(Config, ShippedRolloutAndAvoidabilityHaveTheDocumentedValues) {
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

TEST(Config, ShippedLqrHasTheDocumentedValues) {
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

TEST(Config, ShippedPdmHasTheDocumentedValues) {
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

TEST(Config, ShippedRuleBasedHasTheDocumentedValues) {
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

TEST(Config, ShippedRequestListHasTheDocumentedValues) {
  const Config config = loadConfig(kShipped);
  EXPECT_EQ(config.requests.stride, 2.0);
  EXPECT_EQ(config.requests.ttas, (std::vector<double>{2.0, 3.0, 4.0, 5.0, 6.0}));
  EXPECT_EQ(config.requests.min_ego_speed, 2.0);
}

TEST(Config, ShippedSearchHasTheDocumentedValues) {
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
  EXPECT_EQ(search.min_confidence, 0.05);
}

TEST(Config, ShippedBicycleHasTheDocumentedValues) {
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

TEST(Config, ShippedSteeringHasTheDocumentedValues) {
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

TEST(Config, ShippedVerificationHasTheDocumentedValues) {
  const VerificationOptions verification = loadConfig(kShipped).attack.verification;
  EXPECT_EQ(verification.time_tolerance, 0.5);
  EXPECT_EQ(verification.overlap_tolerance, 0.001);
  EXPECT_EQ(verification.off_road_interval, 0.5);
}

TEST(Config, ShippedTypeRulesAreTheFullOnes) {
  EXPECT_EQ(loadConfig(kShipped).attack.type_rules, TypeRules::kFull);
}

TEST(Config, ShippedEvaluationHasTheDocumentedValues) {
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

TEST(Config, ShippedSpeedModelFitHasTheDocumentedValues) {
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

TEST(Config, ShippedTrainingHasTheDocumentedValues) {
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

TEST(Config, ShippedEgoFuturesHaveTheDocumentedValues) {
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

TEST(Config, ShippedCollisionTypesHaveTheDocumentedBands) {
  const TypeDefinitions types = loadConfig(kShipped).attack.collision_types;
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

TEST(Config, ShippedConversionAndDrawingHaveTheDocumentedValues) {
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

TEST(Config, DrivingSideIsThatOfTheLocationsPrefix) {
  const Config config = loadConfig(kShipped);
  EXPECT_EQ(drivingSide(config, "boston-seaport"), DrivingSide::kRight);
  EXPECT_EQ(drivingSide(config, "singapore-onenorth"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "singapore"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "embedded-left"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "embedded-right-2"), DrivingSide::kRight);
}

TEST(Config, LongestFittingPrefixDecidesTheDrivingSide) {
  Config config;
  config.locations = {{"a", DrivingSide::kRight}, {"a-b", DrivingSide::kLeft}};
  EXPECT_EQ(drivingSide(config, "a-b-c"), DrivingSide::kLeft);
  EXPECT_EQ(drivingSide(config, "a-c"), DrivingSide::kRight);
}

TEST(Config, LocationWithoutAFittingPrefixIsRefusedByName) {
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

TEST_F(SpoiltConfig, UnspoiltCopyLoads) { EXPECT_EQ(complaint(), ""); }

TEST_F(SpoiltConfig, UnknownKeysAreRefused) {
  for (const auto& [file, section] :
       std::vector<std::pair<std::string, std::string>>{{"vehicle_limits.yaml", "vehicle_limits"},
                                                        {"ego_vehicle.yaml", "ego_vehicle"},
                                                        {"prediction.yaml", "prediction"},
                                                        {"encoding.yaml", "encoding"},
                                                        {"evaluation.yaml", "evaluation"},
                                                        {"dataset.yaml", "dataset"},
                                                        {"ego_futures.yaml", "ego_futures"},
                                                        {"speed_model_fit.yaml", "speed_model_fit"},
                                                        {"training.yaml", "training"},
                                                        {"conversion.yaml", "conversion"},
                                                        {"drawing.yaml", "drawing"},
                                                        {"requests.yaml", "requests"},
                                                        {"search.yaml", "search"},
                                                        {"search.yaml", "bicycle"},
                                                        {"verification.yaml", "verification"}}) {
    expectComplaint(file, "\n" + section + ":", "\n" + section + ":\n  stray: 7.5",
                    {section + ".stray", "7.5", "unknown"});
  }
  expectComplaint("collision_types.yaml", "{min_heading: 0.1745",
                  "{stray: 7.5, min_heading: 0.1745",
                  {"collision_types.lane_change.stray", "7.5", "unknown"});
  for (const std::string section : {"paths", "speed", "lateral", "no_profiles"}) {
    expectComplaint("ego_futures.yaml", "\n  " + section + ":",
                    "\n  " + section + ":\n    stray: 7.5",
                    {"ego_futures." + section + ".stray", "7.5", "unknown"});
  }
  expectComplaint("ego_futures.yaml", "\n      speed:", "\n      stray: 7.5\n      speed:",
                  {"ego_futures.speed.feature_weights.stray", "7.5", "unknown"});
  expectComplaint("collision_types.yaml",
                  "  ltap:", "  u_turn: {}\n  ltap:", {"collision_types.u_turn", "unknown"});
}

TEST_F(SpoiltConfig, UnknownSectionsAreRefused) {
  for (const char* file :
       {"vehicle_limits.yaml", "ego_vehicle.yaml", "locations.yaml", "collision_types.yaml",
        "prediction.yaml", "search.yaml", "verification.yaml", "encoding.yaml", "conversion.yaml",
        "drawing.yaml", "requests.yaml", "evaluation.yaml", "dataset.yaml", "ego_futures.yaml",
        "speed_model_fit.yaml", "network.yaml", "training.yaml", "planners.yaml"}) {
    expectComplaint(file, "\n", "\nstray: 7.5\n", {"stray", "7.5", "unknown"});
  }
}

TEST_F(SpoiltConfig, MissingKeysAreNamed) {
  expectComplaint("vehicle_limits.yaml", "max_curvature:", "#",
                  {"vehicle_limits.max_curvature", "missing"});
  expectComplaint("ego_vehicle.yaml", "width:", "#", {"ego_vehicle.width", "missing"});
  expectComplaint("prediction.yaml", "  step:", "#", {"prediction.step", "missing"});
  expectComplaint("encoding.yaml", "max_lanes:", "#", {"encoding.max_lanes", "missing"});
  expectComplaint("search.yaml", "  draws:", "#", {"search.draws", "missing"});
  expectComplaint("search.yaml", "  max_miss:", "#", {"bicycle.max_miss", "missing"});
  expectComplaint("ego_futures.yaml", "neighbors:", "#",
                  {"ego_futures.speed.neighbors", "missing"});
  expectComplaint("ego_futures.yaml", "bend_turn:", "#",
                  {"ego_futures.speed.feature_weights.bend_turn", "missing"});
  expectComplaint("speed_model_fit.yaml", "centers:", "#", {"speed_model_fit.centers", "missing"});
  expectComplaint("network.yaml", "pattern_network:", "other:", {"pattern_network", "missing"});
  expectComplaint("training.yaml", "  max_ways:", "#", {"features.max_ways", "missing"});
  expectComplaint("training.yaml", "  hidden:", "#", {"network.hidden", "missing"});
  expectComplaint("conversion.yaml", "map_radius:", "#", {"conversion.map_radius", "missing"});
  expectComplaint("drawing.yaml", "view_margin:", "#", {"drawing.view_margin", "missing"});
  expectComplaint("requests.yaml", "stride:", "#", {"requests.stride", "missing"});
  expectComplaint("dataset.yaml", "sheet_rows:", "#", {"dataset.sheet_rows", "missing"});
  expectComplaint("dataset.yaml", "    ltap:", "#", {"dataset.attempts.ltap", "missing"});
  expectComplaint("planners.yaml", "wheelbase:", "#", {"bicycle.wheelbase", "missing"});
  expectComplaint("planners.yaml", "ttc_weight:", "#", {"pdm.scoring.ttc_weight", "missing"});
  expectComplaint("planners.yaml", "max_yaw_rate:", "#",
                  {"pdm.scoring.comfort.max_yaw_rate", "missing"});
  expectComplaint("planners.yaml", "bend_length:", "#", {"rule_based.bend_length", "missing"});
  expectComplaint("planners.yaml", "rule_based:", "#",
                  {"planning.intervals.rule_based", "missing"});
  expectComplaint("planners.yaml", "margin:", "#", {"idm.standard.margin", "missing"});
  expectComplaint("planners.yaml", "behind_angle:", "#", {"rollout.fault.behind_angle", "missing"});
  expectComplaint("planners.yaml", "timeout:", "#", {"external.timeout", "missing"});
  expectComplaint("planners.yaml", "draws:", "#", {"avoidability.draws", "missing"});
  expectComplaint("collision_types.yaml", "rules:", "#", {"collision_types.rules", "missing"});
  expectComplaint("verification.yaml", "time_tolerance:", "#",
                  {"verification.time_tolerance", "missing"});
  expectComplaint("collision_types.yaml",
                  "  ltap:", "  turn:", {"collision_types.ltap", "missing"});
  expectComplaint("collision_types.yaml", ", nominal_heading: 0.0,", ",",
                  {"collision_types.rear_end.nominal_heading", "missing"});
}

TEST_F(SpoiltConfig, MissingSectionsAreNamed) {
  write("locations.yaml", "places: {boston: right}\n");
  EXPECT_NE(complaint().find("locations.yaml: locations is missing"), std::string::npos);
  expectComplaint("search.yaml", "bicycle:", "tricycle:", {"bicycle is missing"});
}

TEST_F(SpoiltConfig, MissingAndEmptyAndMalformedFilesAreNamed) {
  fs::remove(directory_ / "encoding.yaml");
  EXPECT_NE(complaint().find("encoding.yaml"), std::string::npos);
  for (const char* text : {"", "encoding", "- 1\n- 2\n", "encoding: {lane_radius: [}\n"}) {
    write("encoding.yaml", text);
    EXPECT_NE(complaint().find("encoding.yaml"), std::string::npos) << text;
  }
  write("encoding.yaml", "encoding: 5\n");
  EXPECT_NE(complaint().find("encoding = 5 is not a mapping"), std::string::npos);
}

TEST_F(SpoiltConfig, KeysGivenTwiceAreRefused) {
  expectComplaint("prediction.yaml",
                  "min_tta:", "min_tta: 0.7\n  min_tta:", {"prediction.min_tta", "twice"});
}

TEST_F(SpoiltConfig, WrongTypesAreRefused) {
  expectComplaint("vehicle_limits.yaml", "max_speed: 25.0", "max_speed: fast",
                  {"vehicle_limits.max_speed", "fast", "not a number"});
  expectComplaint("vehicle_limits.yaml", "max_speed: 25.0", "max_speed: 25.0 km/h",
                  {"vehicle_limits.max_speed", "25.0 km/h", "not a number"});
  expectComplaint("ego_vehicle.yaml", "width: 1.730", "width: [1.73]",
                  {"ego_vehicle.width", "[1.73]", "not a number"});
  expectComplaint("prediction.yaml", "history_frames: 8 ", "history_frames: 8.5 ",
                  {"prediction.history_frames", "8.5", "not an integer"});
  expectComplaint("search.yaml", "draws: 8", "draws: ", {"search.draws", "not an integer"});
  expectComplaint("search.yaml", "depth: 0.25", "depth: deep",
                  {"search.depth", "deep", "not a number"});
  for (const char* rules : {"Full", "some", "[full]", "1"}) {
    expectComplaint("collision_types.yaml", "rules: full", std::string("rules: ") + rules,
                    {"collision_types.rules", rules, "neither full nor angle"});
  }
  expectComplaint("ego_futures.yaml", "kept_offset: 0.3", "kept_offset: 1.3",
                  {"ego_futures.lateral.kept_offset", "1.3", "0 to 1"});
  expectComplaint("ego_futures.yaml", "closing: 22.8", "closing: -1.0",
                  {"ego_futures.speed.feature_weights.closing", "-1.0"});
  expectComplaint("training.yaml", "head: region_proposal", "head: region",
                  {"features.head", "region", "none of"});
  expectComplaint("training.yaml", "agent_frames: 1", "agent_frames: 9",
                  {"features.agent_frames", "9", "8"});
  expectComplaint("training.yaml", "  dropout: 0.15", "  dropout: 1", {"training.dropout", "1"});
  expectComplaint("speed_model_fit.yaml", "folds: 5", "folds: 1",
                  {"speed_model_fit.folds", "1", "2 "});
  expectComplaint("speed_model_fit.yaml", "gain_ridge: 0.1", "gain_ridge: 0",
                  {"speed_model_fit.gain_ridge", "0", "not positive"});
  expectComplaint("locations.yaml", "boston: right", "boston: middle",
                  {"locations.boston", "middle", "right"});
  write("collision_types.yaml", "collision_types: {rules: full, lane_change: 0.2}");
  EXPECT_NE(complaint().find("collision_types.lane_change = 0.2 is not a mapping"),
            std::string::npos);
}

TEST_F(SpoiltConfig, TypeRulesAreReadByName) {
  replace("collision_types.yaml", "rules: full", "rules: angle");
  EXPECT_EQ(loadConfig(directory_.string()).attack.type_rules, TypeRules::kAngle);
}

TEST_F(SpoiltConfig, ColorsAreThreeSharesOfOne) {
  const std::string shipped = "lane_color: [0.68, 0.71, 0.74]";
  for (const char* color : {"[0.68, 0.71]", "[0.68, 0.71, 0.74, 1.0]", "blue", "[0.68, 0.71, 255]",
                            "[-0.1, 0.71, 0.74]", "[.nan, 0.71, 0.74]", "[red, 0.71, 0.74]"}) {
    expectComplaint("drawing.yaml", shipped, std::string("lane_color: ") + color,
                    {"drawing.lane_color"});
  }
  expectComplaint("drawing.yaml", "png_width: 900", "png_width: 10",
                  {"drawing.png_width", "= 10", "within 64"});
}

TEST_F(SpoiltConfig, TheConfidenceCurveIsSharesThatRise) {
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: [0.5",
                  {"search.confidence_curve", "is below the one before"});
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: [-0.1",
                  {"search.confidence_curve", "-0.1"});
  expectComplaint("search.yaml", "confidence_curve: [0.0", "confidence_curve: 0.0 #",
                  {"search.confidence_curve", "is not a list of numbers"});
}

TEST_F(SpoiltConfig, ListsOfNumbersKeepTheirRange) {
  const std::string shipped = "lateral_offsets: [0.0, -1.0, 1.0]";
  expectComplaint("planners.yaml", shipped, "lateral_offsets: [0.0, 20.0]",
                  {"pdm.lateral_offsets", "20.0", "not within -10 to 10"});
  for (const char* offsets : {"[]", "0.0", "[left]"}) {
    expectComplaint("planners.yaml", shipped, std::string("lateral_offsets: ") + offsets,
                    {"pdm.lateral_offsets", "not a"});
  }
  expectComplaint("planners.yaml", "ahead_angle: 0.5236", "ahead_angle: 3.0",
                  {"pdm.scoring.behind_angle", "2.618", "not within 3 to"});
}

TEST_F(SpoiltConfig, NumbersThatAreNotFiniteAreRefused) {
  expectComplaint("vehicle_limits.yaml", "max_braking: 8.0", "max_braking: .inf",
                  {"vehicle_limits.max_braking", ".inf", "not finite"});
  expectComplaint("prediction.yaml", "tail: 2.0", "tail: .nan",
                  {"prediction.tail", ".nan", "not finite"});
  expectComplaint("ego_vehicle.yaml", "center_offset: 1.385", "center_offset: -.inf",
                  {"ego_vehicle.center_offset", "-.inf", "not finite"});
  expectComplaint("search.yaml", "depth: 0.25", "depth: .nan",
                  {"search.depth", ".nan", "not finite"});
}

/// Every number of these files has a sign; -1 is outside all of their domains.
TEST_F(SpoiltConfig, NegativeValuesAreRefusedWhereverTheyMakeNoSense) {
  for (const char* file :
       {"vehicle_limits.yaml", "prediction.yaml", "search.yaml", "verification.yaml",
        "encoding.yaml", "collision_types.yaml", "planners.yaml"}) {
    restore();
    std::stringstream content;
    content << std::ifstream(directory_ / file).rdbuf();
    const std::string text = content.str();
    int spoilt = 0;
    for (std::size_t at = text.find(": "); at != std::string::npos; at = text.find(": ", at + 1)) {
      const std::size_t end = text.find_first_of(" ,}\n", at + 2);
      const std::string value = text.substr(at + 2, end - at - 2);
      if (value.empty() || value.find_first_not_of("0123456789.") != std::string::npos) continue;
      write(file, std::string(text).replace(at + 2, value.size(), "-1"));
      EXPECT_NE(complaint().find("-1"), std::string::npos) << text.substr(at - 20, 30);
      ++spoilt;
    }
    EXPECT_GE(spoilt, 3) << file;
  }
}

TEST_F(SpoiltConfig, ZeroIsRefusedWhereADivisionOrACountNeedsMore) {
  expectComplaint("prediction.yaml", "history_frames: 8", "history_frames: 0",
                  {"prediction.history_frames", "= 0", "within 1"});
  expectComplaint("prediction.yaml", "  step: 0.1", "  step: 0.0", {"prediction.step", "0.0"});
  expectComplaint("prediction.yaml", "motion_frames: 4", "motion_frames: 1",
                  {"prediction.motion_frames", "= 1"});
  expectComplaint("prediction.yaml", "lane_return_distance: 15.0", "lane_return_distance: 0",
                  {"prediction.lane_return_distance", "= 0"});
  expectComplaint("requests.yaml", "stride: 2.0", "stride: 0.0", {"requests.stride", "0.0"});
  expectComplaint("dataset.yaml", "stride: 0.5", "stride: 0.0", {"dataset.begin_stride", "0.0"});
  expectComplaint("dataset.yaml", "min_length: 4.5", "min_length: 3.5", {"dataset.min_length"});
  expectComplaint("dataset.yaml", "max_length: 9.0", "max_length: 4.0", {"dataset.max_length"});
  expectComplaint("dataset.yaml", "rear_end: 1", "rear_end: -1", {"dataset.attempts.rear_end"});
  expectComplaint("dataset.yaml", "min_type_share: 0.15", "min_type_share: 0.21",
                  {"dataset.min_type_share"});
  expectComplaint("dataset.yaml", "max_tta_ratio: 2.0", "max_tta_ratio: 0.9",
                  {"dataset.max_tta_ratio"});
  expectComplaint("dataset.yaml", "val_share: 0.1", "val_share: 0.31", {"dataset.val_share"});
  expectComplaint("requests.yaml", "[2.0,", "[-2.0,", {"requests.ttas", "-2.0"});
  expectComplaint("requests.yaml", "speed: 2.0", "speed: -1", {"requests.min_ego_speed", "-1"});
  expectComplaint("evaluation.yaml", "resamples: 1000", "resamples: 0",
                  {"evaluation.statistics.resamples", "= 0"});
  expectComplaint("evaluation.yaml", "steps_per_interval: 5", "steps_per_interval: 0",
                  {"evaluation.published.steps_per_interval", "= 0"});
  expectComplaint("evaluation.yaml", "box_width: 2.0", "box_width: 0.0",
                  {"evaluation.box_width", "0.0"});
  expectComplaint("search.yaml", "  step: 0.1", "  step: 0", {"search.step", "= 0"});
  for (const std::string count : {"max_attackers: 16", "ego_poses: 3", "draws: 8", "kept: 10"}) {
    const std::string key = count.substr(0, count.find(':'));
    expectComplaint("search.yaml", count, key + ": 0", {"search." + key, "= 0", "within 1"});
  }
  expectComplaint("search.yaml", "iterations: 12", "iterations: 0", {"bicycle.iterations", "= 0"});
  for (const std::string number :
       {"max_miss: 1.0", "position_scale: 0.1", "heading_scale: 0.03", "speed_scale: 3.0",
        "acceleration_scale: 40.0", "curvature_scale: 1.0"}) {
    const std::string key = number.substr(0, number.find(':'));
    expectComplaint("search.yaml", number, key + ": 0", {"bicycle." + key, "= 0", "not positive"});
  }
  expectComplaint("encoding.yaml", "max_lanes: 128", "max_lanes: 0", {"encoding.max_lanes", "= 0"});
  for (const std::string number :
       {"spacing: 1.0", "desired_speed: 10.0", "timeout: 2.0", "return_time: 0.4"}) {
    const std::string key = number.substr(0, number.find(':'));
    expectComplaint("planners.yaml", number, key + ": 0 ", {key, "= 0", "not positive"});
  }
  for (const std::string step :
       {"rollout:\n  step: 0.1", "idm: 0.1", "interval: 0.1", "interval: 0.5", "step: 0.2"}) {
    const std::size_t value = step.rfind(' ') + 1;
    const std::size_t key = step.rfind(' ', value - 2) + 1;
    expectComplaint("planners.yaml", step, step.substr(0, value) + "1e-9",
                    {step.substr(key, value - key - 2), "= 1e-9", "within 0.01"});
  }
  expectComplaint("planners.yaml", "[0.0, -2.0,", "[0.0, -9.0,",
                  {"avoidability.accelerations", "-9.0"});
  expectComplaint("ego_vehicle.yaml", "length: 4.084", "length: 0.0",
                  {"ego_vehicle.length", "0.0"});
}

TEST_F(SpoiltConfig, ValuesBeyondEachOtherOrTheirRangeAreRefused) {
  expectComplaint("prediction.yaml", "max_tta: 9.0", "max_tta: 0.4",
                  {"prediction.max_tta", "0.4", "within 0.5"});
  expectComplaint("prediction.yaml", "min_history_frames: 2", "min_history_frames: 9",
                  {"prediction.min_history_frames", "= 9", "to 8"});
  expectComplaint("collision_types.yaml", "max_heading: 0.5236", "max_heading: 0.1",
                  {"collision_types.lane_change.max_heading", "0.1", "within 0.1745"});
  expectComplaint("collision_types.yaml", "nominal_heading: 0.2618", "nominal_heading: 0.6",
                  {"collision_types.lane_change.nominal_heading", "0.6"});
  expectComplaint("collision_types.yaml", "max_heading: 3.1416", "max_heading: 180",
                  {"collision_types.opposite_direction.max_heading", "180"});
  for (const std::string share : {"limit_margin: 0.998", "good_share: 0.9", "good_off_road: 0.05",
                                  "closeness_weight: 0.2", "min_confidence: 0.05"}) {
    const std::string key = share.substr(0, share.find(':'));
    expectComplaint("search.yaml", share, key + ": 1.1", {"search." + key, "1.1", "within 0 to 1"});
  }
  expectComplaint("collision_types.yaml", "max_approach: 2.3562", "max_approach: 0.7",
                  {"collision_types.junction_crossing.max_approach", "0.7", "within 0.7854"});
  expectComplaint("evaluation.yaml", "confidence: 0.95", "confidence: 1.1",
                  {"evaluation.statistics.confidence", "1.1"});
  expectComplaint("evaluation.yaml", "min_overlap: 0.02", "min_overlap: 2",
                  {"evaluation.published.min_overlap", "= 2"});
  expectComplaint("search.yaml", "tail: 2.0", "tail: 0.05", {"search.tail", "0.05"});
  expectComplaint("ego_vehicle.yaml", "center_offset: 1.385", "center_offset: 2.1",
                  {"ego_vehicle.center_offset", "2.1"});
}

}  // namespace
}  // namespace forge
