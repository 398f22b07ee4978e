#include "collision_forge/attack/forecast/ego_futures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/forecast/ego_sampling.h"
#include "collision_forge/attack/forecast/speed_forecaster.h"

namespace forge {
namespace {

constexpr double kHorizon = 8.0;  // s
constexpr int kCount = 64;
const EgoFutureOptions kOptions = shippedEgoFutureOptions();

/// 40 drivers, each of whom gains or loses speed evenly, as far as that is known.
class EvenDrivers : public SpeedForecaster {
 public:
  explicit EvenDrivers(double gain = 0.02, int intervals_known = 40)
      : gain_(gain), intervals_known_(intervals_known) {}

  SpeedForecast forecast(const DrivingSituation& situation, int intervals) const override {
    constexpr int kDrivers = 40;
    SpeedForecast forecast;
    forecast.speeds.resize(kDrivers, std::min(intervals, intervals_known_));
    forecast.weights = Eigen::VectorXd::Constant(kDrivers, 1.0 / kDrivers);
    for (int i = 0; i < kDrivers; ++i) {
      for (int j = 0; j < forecast.speeds.cols(); ++j) {
        const double speed = situation.past_speeds[0] + gain_ * (i % 9 - 4) * (j + 1);
        forecast.speeds(i, j) = std::max(speed, 0.0);
      }
    }
    return forecast;
  }
  std::shared_ptr<const SpeedForecaster> withoutScene(const std::string&) const override {
    return nullptr;
  }

 private:
  double gain_;  // m/s an interval
  int intervals_known_;
};

std::shared_ptr<const SpeedForecaster> evenDrivers() { return std::make_shared<EvenDrivers>(); }

/// Eastbound to x = 0, then two ways apart by 45 degrees to either side.
std::shared_ptr<LaneMap> evenFork() {
  auto map = emptyMap();
  map->lanes = {straightLane("in", {-200, 0}, {0, 0}, {"left", "right"}),
                straightLane("left", {0, 0}, {150, 75}), straightLane("right", {0, 0}, {150, -75})};
  return map;
}

std::vector<Track> sampleOn(const std::shared_ptr<LaneMap>& map, const Pose2& pose, double speed,
                            std::shared_ptr<const SpeedForecaster> speeds, int count = kCount,
                            std::uint64_t seed = 1) {
  const KinematicEgoFutures sampler(kOptions, std::move(speeds));
  const Snapshot snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, pose, speed), {}, map);
  return sampler.sample(snapshot, LaneIndex(map), kHorizon, count, seed);
}

void expectSane(const std::vector<Track>& tracks, const Pose2& pose) {
  for (const Track& track : tracks) {
    ASSERT_EQ(track.states.size(), 81u);
    EXPECT_EQ(track.id, kEgoId);
    EXPECT_EQ(track.size.length, kEgoSize.length);
    EXPECT_EQ(track.states.front().time, kNow);
    EXPECT_EQ(track.states.front().pose.x, pose.x);
    EXPECT_EQ(track.states.front().pose.y, pose.y);
    EXPECT_EQ(track.states.front().pose.yaw, pose.yaw);
    for (std::size_t i = 1; i < track.states.size(); ++i) {
      const AgentState& state = track.states[i];
      ASSERT_TRUE(state.pose.isFinite() && state.velocity.allFinite());
      ASSERT_NEAR(state.time, kNow + 0.1 * static_cast<double>(i), 1e-9);
      const double step = (state.pose.position() - track.states[i - 1].pose.position()).norm();
      ASSERT_LT(step, 2.5) << "at " << i;
      ASSERT_LT(std::abs(angleBetween(track.states[i - 1].pose.yaw, state.pose.yaw)), 0.2);
    }
  }
}

std::vector<double> lastX(const std::vector<Track>& tracks) {
  std::vector<double> values;
  for (const Track& track : tracks) values.push_back(track.states.back().pose.x);
  std::sort(values.begin(), values.end());
  return values;
}

TEST(EgoFutures, StartNowAndMoveSmoothly) {
  const Pose2 pose{-100, 0.4, 0.03};
  const auto tracks = sampleOn(twoLaneRoad(), pose, 10.0, evenDrivers());
  ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kCount));
  expectSane(tracks, pose);
}

TEST(EgoFutures, OnAStraightLaneKeepToIt) {
  const auto tracks = sampleOn(twoLaneRoad(), {-100, 0, 0}, 10.0, evenDrivers());
  const auto beside = std::count_if(tracks.begin(), tracks.end(), [](const Track& track) {
    return std::abs(track.states.back().pose.y) > 1.5;
  });
  EXPECT_LE(beside, 3);
}

TEST(EgoFutures, AnOffsetFromTheLaneDecaysToAShare) {
  double mean = 0.0;
  for (const Track& track : sampleOn(twoLaneRoad(), {-100, -1.0, 0}, 10.0, evenDrivers())) {
    mean += track.states.back().pose.y / kCount;
  }
  EXPECT_NEAR(mean, kKeptOffset * -1.0, 0.2);
}

TEST(EgoFutures, SpreadTheirSpeedsAsRecorded) {
  // Drivers gain -0.08 to 0.08 m/s each 0.5 s; what happened before tells which nearly, but the
  // distance driven is 80 m at 10 m/s give or take 0.08 * 16 * 17 / 2 * 0.5 = 5.4 m.
  const auto x = lastX(sampleOn(twoLaneRoad(), {-100, 0, 0}, 10.0, evenDrivers()));
  EXPECT_NEAR(x[kCount / 2], -20.0, 2.0);
  EXPECT_GT(x.back() - x.front(), 1.0);
  EXPECT_LT(x.back() - x.front(), 2 * 5.5);
}

TEST(EgoFutures, PathsOfEqualCostAreSampledEquallyOften) {
  const auto tracks = sampleOn(evenFork(), {-30, 0, 0}, 8.0, evenDrivers());
  int left = 0;
  int right = 0;
  for (const Track& track : tracks) {
    const Pose2& end = track.states.back().pose;
    left += end.y > 8.0;
    right += end.y < -8.0;
  }
  EXPECT_NEAR(left, right, 1);
  EXPECT_GE(left + right, 56);
}

TEST(EgoFutures, WithoutProfilesTheAccelerationDecays) {
  Track ego{kEgoId, AgentClass::kCar, kEgoSize, {}};
  for (int i = -7; i <= 0; ++i) {
    const double t = 0.5 * i;
    ego.states.push_back({kNow + t, {10 * t + 0.5 * t * t, 0, 0}, Vector2::Zero()});
  }
  const KinematicEgoFutures sampler(kOptions, nullptr);
  const auto tracks = sampler.sample(snapshotOf(ego, {}, twoLaneRoad()), LaneIndex(twoLaneRoad()),
                                     kHorizon, kCount, 1);
  expectSane(tracks, ego.states.back().pose);
  const auto x = lastX(tracks);
  const double steady = (10.0 - 0.25) * kHorizon;  // over the last 0.5 s
  EXPECT_NEAR(0.5 * (x[kCount / 2 - 1] + x[kCount / 2]), steady + 1.0 * (kHorizon - 1.0), 2.0);
  EXPECT_GT(x.back() - x.front(), 20.0);
}

TEST(EgoFutures, AStandingEgoStandsOrSetsOff) {
  for (const auto& speeds : {evenDrivers(), std::shared_ptr<const SpeedForecaster>()}) {
    const Pose2 pose{-20, 0.2, 0};
    const auto tracks = sampleOn(evenFork(), pose, 0.0, speeds);
    ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kCount));
    expectSane(tracks, pose);
    EXPECT_GE(lastX(tracks).front(), -20.0 - 1e-6);
  }
}

TEST(EgoFutures, AReversingEgoContinuesToReverseOrStops) {
  const Pose2 pose{-100, 0, 0.03};
  const auto tracks = sampleOn(twoLaneRoad(), pose, -2.0, evenDrivers());
  ASSERT_EQ(tracks.size(), static_cast<std::size_t>(kCount));
  expectSane(tracks, pose);
  int reversing = 0;
  int standing = 0;
  for (const Track& track : tracks) {
    const AgentState& last = track.states.back();
    for (const AgentState& state : track.states) {
      EXPECT_LE(state.pose.heading().dot(state.velocity), 1e-6) << "never ahead";
    }
    EXPECT_LE(last.pose.x, pose.x);
    EXPECT_NEAR(last.pose.yaw, pose.yaw, 0.8);
    reversing += last.velocity.norm() > 0.5;
    standing += last.velocity.norm() < 0.1;
  }
  EXPECT_GE(reversing, kCount / 4);
  EXPECT_GE(standing, kCount / 3);
}

TEST(EgoFutures, RejectInvalidArguments) {
  const KinematicEgoFutures sampler(kOptions, nullptr);
  Snapshot snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {0, 0, 0}, 5.0), {}, twoLaneRoad());
  const LaneIndex lanes(twoLaneRoad());
  const double infinity = std::numeric_limits<double>::infinity();
  EXPECT_THROW(sampler.sample(snapshot, lanes, 0.0, 4, 1), std::invalid_argument);
  EXPECT_THROW(sampler.sample(snapshot, lanes, infinity, 4, 1), std::invalid_argument);
  EXPECT_THROW(sampler.sample(snapshot, lanes, 5.0, -1, 1), std::invalid_argument);
  snapshot.ego.states.clear();
  EXPECT_THROW(sampler.sample(snapshot, lanes, 5.0, 4, 1), std::invalid_argument);
}

}  // namespace
}  // namespace forge
