#include "collision_forge/attack/network/pattern_network.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "attack/network/sample_network.h"
#include "collision_forge/attack/network/predicted_scene.h"

namespace forge {
namespace {

constexpr double kTta = 3.0;  // s

SceneFeatures sampleFeatures() {
  const Snapshot snapshot = junctionSnapshot();
  return sceneFeatures(observedSnapshot(snapshot, {}), lanesOf(snapshot), smallFeatures());
}

/// Rows of the second and third agent, or of two lanes, exchanged.
void exchange(RowMatrix& rows, Eigen::VectorXf& mask, Eigen::Index a, Eigen::Index b,
              Eigen::Index size) {
  const RowMatrix first = rows.middleRows(a * size, size);
  const Eigen::VectorXf first_mask = mask.segment(a * size, size);
  rows.middleRows(a * size, size) = rows.middleRows(b * size, size).eval();
  mask.segment(a * size, size) = mask.segment(b * size, size).eval();
  rows.middleRows(b * size, size) = first;
  mask.segment(b * size, size) = first_mask;
}

std::string complaintAbout(PatternWeights weights) {
  try {
    PatternNetwork network(std::move(weights));
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(PatternNetwork, OrderOfAgentsAndLanesDoesNotMatter) {
  const PatternNetwork network(randomWeights());
  const SceneFeatures features = sampleFeatures();
  SceneFeatures shuffled = features;
  exchange(shuffled.agents, shuffled.agent_mask, 1, 3, 8);
  exchange(shuffled.lanes, shuffled.lane_mask, 0, 2, 5);
  const Eigen::VectorXf a = network.encode(features);
  const Eigen::VectorXf b = network.encode(shuffled);
  EXPECT_LT((a - b).cwiseAbs().maxCoeff(), 1e-5F);
  // but what they are does
  SceneFeatures other = features;
  other.agents(15, 0) += 0.5F;
  other.lanes(0, 1) += 0.5F;
  EXPECT_GT((network.encode(other) - a).cwiseAbs().maxCoeff(), 1e-4F);
}

TEST(PatternNetwork, ProbabilitiesSumToOneAndSpreadsArePositive) {
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const PatternNetwork network(randomWeights());
  const PredictedScene scene(network, snapshot, lanes, 9.0, shippedEgoFutureOptions());
  double sum = 0.0;
  for (const EgoComponent& component : scene.egoAfter(kTta, std::nullopt)) {
    sum += component.probability;
    EXPECT_GT(component.along, 0.0);
    EXPECT_GT(component.across, 0.0);
    EXPECT_TRUE(component.pose.isFinite());
  }
  EXPECT_NEAR(sum, 1.0, 1e-5);
}

TEST(PatternNetwork, RejectsNumbersThatAreNotFinite) {
  const PatternNetwork network(randomWeights());
  SceneFeatures features = sampleFeatures();
  features.lanes(3, 2) = std::numeric_limits<float>::quiet_NaN();
  EXPECT_THROW(network.encode(features), std::invalid_argument);
}

TEST(PatternNetwork, RejectsWeightsOfAnotherArchitecture) {
  PatternWeights missing = randomWeights();
  missing.layers.erase("query");
  EXPECT_NE(complaintAbout(missing).find("layer query is missing"), std::string::npos);
  PatternWeights unknown = randomWeights();
  unknown.layers["extra"] = unknown.layers["query"];
  EXPECT_NE(complaintAbout(unknown).find("layer extra is unknown"), std::string::npos);
  PatternWeights other = randomWeights();
  other.layers["scene"].matrix.conservativeResize(12, 5);
  EXPECT_NE(complaintAbout(other).find("layer scene is 12 x 5, not 12 x 25"), std::string::npos)
      << complaintAbout(other);
  PatternWeights broken = randomWeights();
  broken.layers["key"].bias[2] = std::numeric_limits<float>::infinity();
  EXPECT_NE(complaintAbout(broken).find("layer key"), std::string::npos);
}

TEST(PatternNetwork, RejectsWeightsOutOfRange) {
  for (const float number : {3e38F, -2e6F, std::numeric_limits<float>::quiet_NaN()}) {
    PatternWeights weights = randomWeights();
    weights.layers.at("anchor_first").matrix(0, 0) = number;
    EXPECT_THROW(PatternNetwork{weights}, std::invalid_argument) << number;
    weights = randomWeights();
    weights.layers.at("candidate_first").bias[0] = number;
    EXPECT_THROW(PatternNetwork{weights}, std::invalid_argument) << number;
  }
}

TEST(PatternNetwork, OutputsOutOfRangeAreErrors) {
  const Snapshot snapshot = junctionSnapshot();
  const LaneIndex lanes = lanesOf(snapshot);
  const auto networkWithLarge = [](const char* layer) {
    PatternWeights weights = randomWeights();
    weights.layers.at(layer).bias.setConstant(9e5F);
    return PatternNetwork(weights);
  };
  const PatternNetwork of_ego = networkWithLarge("anchor_last");
  const PredictedScene ego(of_ego, snapshot, lanes, 9.0, shippedEgoFutureOptions());
  EXPECT_THROW(ego.egoAfter(kTta, std::nullopt), std::runtime_error);
  const PatternNetwork of_others = networkWithLarge("candidate_last");
  const PredictedScene others(of_others, snapshot, lanes, 9.0, shippedEgoFutureOptions());
  EXPECT_THROW(others.judge({&snapshot.agents[0]}, {10.0, 0.0, 0.0}, kTta, CollisionType::kLtap),
               std::runtime_error);
}

TEST(MedianPose, HasTheLeastExpectedDistance) {
  const std::vector<EgoComponent> components = {{0.6, {0.0, 0.0, 0.1}, 1.0, 1.0, 0, 0.0},
                                                {0.3, {10.0, 0.0, 0.2}, 1.0, 1.0, 0, 10.0},
                                                {0.1, {0.0, 30.0, 2.0}, 1.0, 1.0, 1, 30.0}};
  const Pose2 median = medianPose(components);
  const auto expected = [&](const Vector2& place) {
    double sum = 0.0;
    for (const auto& component : components) {
      sum += component.probability * (component.pose.position() - place).norm();
    }
    return sum;
  };
  for (const Vector2& step : {Vector2(0.3, 0.0), Vector2(-0.3, 0.0), Vector2(0.0, 0.3)}) {
    EXPECT_LE(expected(median.position()), expected(median.position() + step));
  }
  EXPECT_NEAR(median.yaw, 0.1, 0.01);
}

TEST(LogDensity, IntegratesToOne) {
  const std::vector<EgoComponent> components = {{0.7, {1.0, 0.0, 0.5}, 0.8, 0.3, 0, 0.0},
                                                {0.3, {4.0, 2.0, -0.4}, 0.5, 0.6, 0, 0.0}};
  constexpr double kStep = 0.1;
  double sum = 0.0;
  for (double x = -15.0; x < 20.0; x += kStep) {
    for (double y = -15.0; y < 17.0; y += kStep) {
      sum += std::exp(logDensity(components, {x, y})) * kStep * kStep;
    }
  }
  EXPECT_NEAR(sum, 1.0, 1e-3);
}

TEST(PatternNetwork, HasAFoldForEachLeftOutScene) {
  PatternWeights first = randomWeights(1);
  first.left_out_scenes = {"scene-a", "scene-b"};
  PatternWeights second = randomWeights(2);
  second.left_out_scenes = {"scene-c"};
  const PatternNetwork network(randomWeights(0), {first, second});
  EXPECT_EQ(network.withoutScene("scene-b"), network.folds()[0]);
  EXPECT_EQ(network.withoutScene("scene-c"), network.folds()[1]);
  EXPECT_EQ(network.folds()[1]->weights().left_out_scenes, second.left_out_scenes);
  EXPECT_EQ(network.withoutScene("elsewhere"), nullptr);
  second.left_out_scenes = {"scene-a"};
  EXPECT_THROW(PatternNetwork(randomWeights(0), {first, second}), std::invalid_argument);
}

}  // namespace
}  // namespace forge
