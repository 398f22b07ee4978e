#include "collision_forge/attack/search/added_paths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "attack/search/added_scene.h"

namespace forge {
namespace {

constexpr FittingLane kEast{0, 200.0, {}};  // at the origin
constexpr FittingLane kWest{1, 200.0, {}};

class AddedPathsTest : public testing::Test {
 protected:
  /// The only way to a lane.
  const AddedPath& wayTo(const FittingLane& lane) {
    input_ = std::make_unique<AddedVehicleInput>(scene_.input());
    ways_ = std::make_unique<AddedPaths>(*input_, options_);
    EXPECT_EQ(ways_->to(lane).size(), 1u);
    return *ways_->to(lane).front();
  }

  AddedScene scene_;
  const AddedVehicleOptions options_ = shippedOptions().added;
  std::unique_ptr<AddedVehicleInput> input_;
  std::unique_ptr<AddedPaths> ways_;
};

TEST(AddedFlow, ReportsWhenItPassesAPlace) {
  const AddedFlow flow{{-2.0, 0.0, 3.0, 5.0}, {0.0, 10.0, 10.0, 20.0}};
  EXPECT_NEAR(flow.passing(5.0).value(), -1.0, 1e-9);
  EXPECT_NEAR(flow.passing(10.0).value(), 3.0, 1e-9) << "once it goes on";
  EXPECT_NEAR(flow.passing(15.0).value(), 4.0, 1e-9);
  EXPECT_FALSE(flow.passing(20.0));
  EXPECT_FALSE(flow.passing(-1.0));
}

TEST(AddedFlow, IsConstantBeyondItsEnds) {
  const AddedFlow flow{{-2.0, 0.0, 3.0, 5.0}, {0.0, 10.0, 10.0, 20.0}};
  EXPECT_NEAR(flow.at(-0.5), 7.5, 1e-9);
  EXPECT_NEAR(flow.at(1.0), 10.0, 1e-9);
  EXPECT_NEAR(flow.at(-9.0), 0.0, 1e-9) << "stays at its ends";
  EXPECT_NEAR(flow.at(9.0), 20.0, 1e-9);
  EXPECT_TRUE(flow.covers(5.0));
  EXPECT_FALSE(flow.covers(5.1));
}

TEST_F(AddedPathsTest, AreLongEnoughForTheFastestVehicle) {
  scene_.map->lanes.front() = straightLane("east", {-600.0, 0.0}, {200.0, 0.0});
  const FittingLane east{0, 600.0, {}};
  const double known = AddedPath::kStep * static_cast<double>(stepsBack(*scene_.input().past));
  const auto behind = [&] { return wayTo(east).path.project({0.0, 0.0}); };
  EXPECT_LT(behind(), 25.0 * known);
  scene_.add("fast", {-60.0, 0.0, 0.0}, 25.0);
  EXPECT_GE(behind(), 25.0 * (known + scene_.request.tta) - 1e-6);
}

TEST_F(AddedPathsTest, LimitSpeedsInABendAndAroundIt) {
  constexpr double kRadius = 12.0;
  Lane& lane = scene_.map->lanes.front();
  lane.centerline.clear();
  for (double x = -60.0; x < 0.0; x += 1.0) lane.centerline.push_back({x, 0.0, 0.0});
  for (double angle = 0.0; angle < M_PI_2; angle += 1.0 / kRadius) {
    lane.centerline.push_back(
        {kRadius * std::sin(angle), kRadius * (1.0 - std::cos(angle)), angle});
  }
  for (double y = kRadius + 1.0; y < 60.0; y += 1.0)
    lane.centerline.push_back({kRadius, y, M_PI_2});
  const AddedPath& way = wayTo({0, 120.0, {}});
  const double slowest = std::sqrt(AddedPath::kLateral * kRadius);
  EXPECT_NEAR(way.cap(60.0 + 0.5 * kRadius * M_PI_2), slowest, 0.3);
  EXPECT_NEAR(way.cap(20.0), std::sqrt(slowest * slowest + 2.0 * AddedPath::kBraking * 40.0), 1.5);
  EXPECT_GT(way.cap(115.0), 1.5 * slowest) << "leaves the bend";
  for (std::size_t i = 1; i < way.caps.size(); ++i) {
    const double change = way.caps[i] * way.caps[i] - way.caps[i - 1] * way.caps[i - 1];
    EXPECT_LE(std::abs(change), 2.0 * AddedPath::kBraking + 1e-9) << i << " m along";
  }
  EXPECT_EQ(way.cap(-5.0), way.caps.front());
  EXPECT_EQ(way.cap(1e4), way.caps.back());
}

TEST_F(AddedPathsTest, ContainTheSpeedsOfVehiclesOnThem) {
  scene_.add("ahead", {-10.0, 0.3, 0.0}, 9.0);
  scene_.add("as fast", {10.0, 0.0, 0.0}, 9.4);
  scene_.add("stands", {-100.0, 0.0, 0.0}, 0.0);
  scene_.add("oncoming", {-20.0, 3.5, M_PI}, 12.0);
  scene_.add("far", {100.0, 0.0, 0.0}, 15.0);
  EXPECT_EQ(wayTo(kEast).speeds, std::vector<double>{9.0});
  EXPECT_EQ(wayTo(kWest).speeds, std::vector<double>{12.0});
}

TEST_F(AddedPathsTest, ContainFlowsOfVehiclesOnThem) {
  scene_.add("ahead", {-20.0, 0.0, 0.0}, 10.0);
  scene_.add("stands", {-100.0, 0.0, 0.0}, 0.0);
  scene_.add("oncoming", {-20.0, 3.5, M_PI}, 12.0);
  const AddedPath& way = wayTo(kEast);
  ASSERT_EQ(way.flows.size(), 1u);
  const AddedFlow& flow = way.flows.front();
  const double origin = way.path.project({0.0, 0.0});
  EXPECT_NEAR(flow.passing(origin).value(), 2.0, 1e-6) << "later than now";
  EXPECT_NEAR(flow.passing(origin - 60.0).value(), -4.0, 1e-6) << "earlier";
  for (std::size_t i = 1; i < flow.times.size(); ++i) EXPECT_GT(flow.times[i], flow.times[i - 1]);
}

TEST_F(AddedPathsTest, EndAFlowWhereItLeavesThePath) {
  // It drives off to the left, on no lane from 2.5 s ago on.
  Track leaves = AddedScene::longPast("leaves", kCarSize, {-20.0, 0.0, 0.0}, 10.0);
  for (AgentState& state : leaves.states) {
    if (state.time > kNow - 2.5) state.pose.y = 20.0;
  }
  scene_.others.push_back(leaves);
  const AddedPath& way = wayTo(kEast);
  ASSERT_EQ(way.flows.size(), 1u);
  EXPECT_NEAR(way.flows.front().times.back(), -2.5, 1e-6);
}

TEST(AddSpeed, SkipsSpeedsThatAreAlreadyThere) {
  std::vector<double> speeds;
  for (const double speed : {8.0, 8.9, 9.0, 7.5, 5.0}) addSpeed(speed, speeds);
  EXPECT_EQ(speeds, (std::vector<double>{8.0, 9.0, 5.0}));
}

}  // namespace
}  // namespace forge
