#include "collision_forge/base/map/lane_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include "base/map/winding_lanes.h"
#include "collision_forge/base/map/lane_queries.h"

namespace forge {
namespace {

constexpr double kEverywhere = std::numeric_limits<double>::infinity();
constexpr double kDegree = M_PI / 180.0;

LaneIndex indexOf(const LaneMap& map) { return LaneIndex(std::make_shared<LaneMap>(map)); }

std::vector<LaneSample> allSamples(const LaneIndex& index) {
  return index.grid().samplesNear({0.0, 0.0}, kEverywhere);
}

double distanceOf(const LaneSample& sample, const Pose2& pose) {
  return (sample.position - pose.position()).norm();
}

double turnOf(const LaneSample& sample, const Pose2& pose) {
  return std::abs(angleBetween(pose.yaw, std::atan2(sample.heading.y(), sample.heading.x())));
}

/// Eastbound on y = 0, westbound on y = 3.5, from x = -50 to 50.
LaneMap road() {
  LaneMap map;
  map.lanes = {makeLane("east", {{-50.0, 0.0}, {50.0, 0.0}}),
               makeLane("west", {{50.0, 3.5}, {-50.0, 3.5}})};
  return map;
}

TEST(LaneGrid, SamplesFollowEveryCentrelineHalfAMetreApart) {
  LaneRandom random(1);
  const LaneIndex index = indexOf(randomMap(random, 30));
  std::vector<double> last(index.map().lanes.size(), -1.0);
  for (const LaneSample& sample : allSamples(index)) {
    const Polyline& line = index.centerline(sample.lane).value();
    const Pose2 pose = line.poseAt(sample.arc_length);
    EXPECT_NEAR(distanceOf(sample, pose), 0.0, 1e-9);
    EXPECT_NEAR(turnOf(sample, pose), 0.0, 1e-9);
    const bool is_first = last[sample.lane] < 0.0;
    EXPECT_GT(sample.arc_length, last[sample.lane]);
    EXPECT_LE(sample.arc_length - last[sample.lane], is_first ? 1.0 : 0.5 + 1e-9);
    if (is_first) {
      EXPECT_EQ(sample.arc_length, 0.0);
    }
    last[sample.lane] = sample.arc_length;
  }
  for (std::size_t lane = 0; lane < last.size(); ++lane) {
    const auto& line = index.centerline(lane);
    EXPECT_NEAR(last[lane], line ? line->length() : -1.0, 1e-9) << "to its very end";
  }
}

TEST(LaneGrid, AgreesWithASearchOverAllSamples) {
  LaneRandom random(2);
  const LaneIndex index = indexOf(randomMap(random, 60));
  const std::vector<LaneSample> all = allSamples(index);
  int on_lane = 0, wrong_way = 0;
  for (int i = 0; i < 2000; ++i) {
    const Pose2 pose{random.between(-120.0, 120.0), random.between(-120.0, 120.0),
                     random.between(-M_PI, M_PI)};
    const double reach = random.between(0.0, i % 10 == 0 ? 100.0 : 8.0);
    const double heading = random.between(0.0, M_PI);
    std::vector<LaneSample> near;
    std::copy_if(all.begin(), all.end(), std::back_inserter(near),
                 [&](const LaneSample& sample) { return distanceOf(sample, pose) <= reach; });
    const auto found = index.grid().samplesNear(pose.position(), reach);
    ASSERT_EQ(found.size(), near.size());
    for (std::size_t k = 0; k < near.size(); ++k) {
      EXPECT_EQ(found[k].lane, near[k].lane);
      EXPECT_EQ(found[k].arc_length, near[k].arc_length);
    }
    const auto headsWithin = [&](double turn) {
      return std::any_of(near.begin(), near.end(),
                         [&](const LaneSample& sample) { return turnOf(sample, pose) <= turn; });
    };
    EXPECT_EQ(index.grid().isOnLane(pose, reach, heading), headsWithin(heading));
    EXPECT_EQ(index.grid().isWrongWay(pose, reach), !near.empty() && !headsWithin(M_PI_2));
    on_lane += headsWithin(heading);
    wrong_way += index.grid().isWrongWay(pose, reach);
  }
  EXPECT_GT(on_lane, 200);
  EXPECT_GT(wrong_way, 100);
}

TEST(LaneGrid, IsOnLaneWhenNearAndHeadingAlongIt) {
  const LaneIndex index = indexOf(road());
  const auto isOn = [&](const Pose2& pose) {
    return index.grid().isOnLane(pose, 2.0, 25.0 * kDegree);
  };
  EXPECT_TRUE(isOn({0.0, 0.0, 0.0}));
  EXPECT_TRUE(isOn({0.0, -1.9, 24.0 * kDegree}));
  EXPECT_FALSE(isOn({0.0, -2.1, 0.0})) << "too far";
  EXPECT_FALSE(isOn({0.0, 0.0, 26.0 * kDegree})) << "askew";
  EXPECT_FALSE(isOn({0.0, 0.0, M_PI})) << "the other way";
  EXPECT_TRUE(isOn({0.0, 1.8, M_PI})) << "on the other lane";
  EXPECT_TRUE(isOn({51.9, 0.0, 0.0})) << "just beyond the end";
  EXPECT_FALSE(isOn({52.1, 0.0, 0.0}));
  EXPECT_TRUE(index.grid().isOnLane({0.0, 0.0, M_PI}, 1.0, M_PI)) << "any heading will do";
}

TEST(LaneGrid, IsWrongWayWithOnlyOncomingLanesNear) {
  const LaneIndex index = indexOf(road());
  const auto isWrong = [&](const Pose2& pose) { return index.grid().isWrongWay(pose, 2.0); };
  EXPECT_TRUE(isWrong({0.0, 3.5, 0.0}));
  EXPECT_TRUE(isWrong({0.0, 3.5, 89.0 * kDegree}));
  EXPECT_FALSE(isWrong({0.0, 3.5, 91.0 * kDegree})) << "across";
  EXPECT_FALSE(isWrong({0.0, 1.8, 0.0})) << "between both";
  EXPECT_FALSE(isWrong({0.0, 0.0, 0.0}));
  EXPECT_FALSE(isWrong({0.0, 10.0, 0.0})) << "no lane there";
}

TEST(LaneGrid, FindsLanesFarFromTheOrigin) {
  LaneMap map = road();
  for (Lane& lane : map.lanes) {
    for (Pose2& pose : lane.centerline) pose.x -= 4e6;
  }
  EXPECT_TRUE(indexOf(map).grid().isOnLane({-4e6, 0.0, 0.0}, 2.0, 0.1));
}

TEST(LaneGrid, RejectsACentrelineOfADamagedMap) {
  LaneMap map;
  map.lanes = {makeLane("endless", {{0.0, 0.0}, {1e6, 0.0}})};
  EXPECT_THROW(indexOf(map), std::invalid_argument);
}

}  // namespace
}  // namespace forge
