#include "collision_forge/attack/verify/manoeuvre_detection.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// An attacker that is driven by hand, and the ego that it hits after four seconds.
class ManoeuvreTest : public testing::Test {
 protected:
  static constexpr double kContact = 4.0;

  void road(std::shared_ptr<LaneMap> map) { lanes_ = std::make_unique<LaneIndex>(std::move(map)); }

  void ego(const Pose2& now, double speed) {
    snapshot_.now = kNow;
    future_.ego = futureTrack("ego", kEgoSize, now, speed);
    report_.contact = true;
    report_.contact_time = kNow + kContact;
  }

  /// Pose, speed, acceleration and curvature by time.
  void attacker(const std::function<TrajectoryPoint(double)>& at) {
    trajectory_ = {"attacker", AgentClass::kCar, kCarSize, {}};
    for (int i = 0; i <= 60; ++i) {
      trajectory_.points.push_back(at(0.1 * i));
      trajectory_.points.back().time = kNow + 0.1 * i;
    }
  }

  DetectedManoeuvre detect(CollisionType type) const {
    const CollisionRequest request = believableRequestFor(type, kContact);
    return detectManoeuvre(trajectory_, report_, {snapshot_, future_, request, *lanes_},
                           shippedOptions().verification);
  }

  Snapshot snapshot_;
  Future future_;
  CollisionReport report_;
  AttackerTrajectory trajectory_;
  std::unique_ptr<LaneIndex> lanes_;
};

TEST_F(ManoeuvreTest, DetectsABrakingLeader) {
  road(twoLaneRoad());
  ego({0.0, 0.0, 0.0}, 8.0);
  report_.ego_side = Side::kFront;
  attacker([](double t) {
    const double braked = std::max(0.0, t - 2.5);
    return TrajectoryPoint{0.0,
                           {8.0 + 8.0 * t - 2.0 * braked * braked, 0.0, 0.0},
                           8.0 - 4.0 * braked,
                           t > 2.5 ? -4.0 : 0.0,
                           0.0};
  });
  const DetectedManoeuvre found = detect(CollisionType::kRearEnd);
  EXPECT_EQ(found.manoeuvre, Manoeuvre::kLeadBrakes);
  EXPECT_NEAR(found.begin, kNow + 2.5, 0.15);
}

TEST_F(ManoeuvreTest, DetectsASlowLeaderAndAFastFollower) {
  road(twoLaneRoad());
  ego({0.0, 0.0, 0.0}, 8.0);
  attacker([](double t) {
    return TrajectoryPoint{0.0, {20.0 + 4.0 * t, 0.0, 0.0}, 4.0, 0.0, 0.0};
  });
  report_.ego_side = Side::kFront;
  EXPECT_EQ(detect(CollisionType::kRearEnd).manoeuvre, Manoeuvre::kLeadSlow);
  report_.ego_side = Side::kRear;
  EXPECT_EQ(detect(CollisionType::kRearEnd).manoeuvre, Manoeuvre::kFollowerCloses);
}

TEST_F(ManoeuvreTest, DetectsTheManoeuvreOfAnAngleTypeFromDirectionsAndTurns) {
  road(fourWayJunction());
  ego({-40.0, -1.75, 0.0}, 8.0);
  // Turns by `turn` from the heading `from` in the last two seconds.
  const auto manoeuvre = [&](CollisionType type, double from, double turn) {
    attacker([=](double t) {
      const double yaw = from + turn * std::clamp(0.5 * (t - 2.0), 0.0, 1.0);
      return TrajectoryPoint{0.0, {4.0 * t - 16.0, 0.0, wrapAngle(yaw)}, 4.0, 0.0, 0.0};
    });
    report_.attacker_at_contact = poseAt(trajectory_, report_.contact_time);
    report_.relative_heading = report_.attacker_at_contact.yaw;
    return detect(type).manoeuvre;
  };
  const CollisionType same = CollisionType::kAngleSameDirection;
  const CollisionType opposite = CollisionType::kAngleOppositeDirection;
  EXPECT_EQ(manoeuvre(same, M_PI_2, -0.8), Manoeuvre::kTurnIntoPath);
  EXPECT_EQ(manoeuvre(same, 1.0, 0.0), Manoeuvre::kStraightCrossing);
  EXPECT_EQ(manoeuvre(same, 0.0, -0.9), Manoeuvre::kSameDirectionTurn);
  EXPECT_EQ(manoeuvre(opposite, M_PI_2, 0.9), Manoeuvre::kTurnIntoPath);
  EXPECT_EQ(manoeuvre(opposite, M_PI, 0.9), Manoeuvre::kTurnAcrossPath);
  EXPECT_EQ(manoeuvre(opposite, M_PI, 0.3), Manoeuvre::kCentreLineCrossing);
}

TEST_F(ManoeuvreTest, DetectsACutInFromTheLaneDeparture) {
  auto map = emptyMap();
  map->lanes = {straightLane("left", {-200.0, 3.5}, {200.0, 3.5}),
                straightLane("right", {-200.0, 0.0}, {200.0, 0.0})};
  road(map);
  ego({0.0, 0.0, 0.0}, 8.0);
  attacker([](double t) {
    const double y = 3.5 - 1.5 * std::max(0.0, t - 2.5);
    return TrajectoryPoint{0.0, {8.0 * t, y, 0.0}, 8.0, 0.0, 0.0};
  });
  const DetectedManoeuvre found = detect(CollisionType::kLaneChange);
  EXPECT_EQ(found.manoeuvre, Manoeuvre::kCutIn);
  EXPECT_NEAR(found.begin, kNow + 2.7, 0.15) << "0.3 m from its way";
  attacker([](double t) { return TrajectoryPoint{0.0, {8.0 * t, 3.4, 0.0}, 8.0, 0.0, 0.0}; });
  EXPECT_EQ(detect(CollisionType::kLaneChange).manoeuvre, Manoeuvre::kMerge);
}

TEST_F(ManoeuvreTest, DetectsADriftBesideTheEgo) {
  road(twoLaneRoad());
  ego({0.0, 0.0, 0.0}, 8.0);
  attacker([](double t) {
    const double y = -1.8 + 0.5 * std::max(0.0, t - 3.0);
    return TrajectoryPoint{0.0, {8.0 * t, y, 0.0}, 8.0, 0.0, 0.0};
  });
  EXPECT_EQ(detect(CollisionType::kLaneChange).manoeuvre, Manoeuvre::kDrift);
}

TEST_F(ManoeuvreTest, DetectsAMerge) {
  auto map = emptyMap();
  map->lanes = {straightLane("main", {-200.0, 0.0}, {200.0, 0.0}),
                straightLane("ramp", {-60.0, -12.0}, {60.0, 0.0})};
  road(map);
  ego({0.0, 0.0, 0.0}, 8.0);
  attacker([](double t) {
    return TrajectoryPoint{0.0, {8.0 * t, -6.0 + 0.8 * t, 0.0997}, 8.0, 0.0, 0.0};
  });
  EXPECT_EQ(detect(CollisionType::kLaneChange).manoeuvre, Manoeuvre::kMerge);
}

TEST_F(ManoeuvreTest, DetectsAPullOut) {
  road(twoLaneRoad());
  ego({0.0, 0.0, 0.0}, 8.0);
  attacker([](double t) {
    const double way = std::max(0.0, t - 2.0);
    return TrajectoryPoint{0.0, {28.0 + way * way, -4.0 + way, 0.0}, 2.0 * way, 2.0, 0.0};
  });
  EXPECT_EQ(detect(CollisionType::kLaneChange).manoeuvre, Manoeuvre::kPullOut);
  EXPECT_NEAR(detect(CollisionType::kLaneChange).begin, kNow + 2.3, 0.11) << "when it moves off";
  const auto movesOffFrom = [&](double across) {
    attacker([across](double t) {
      const double way = std::max(0.0, t - 2.0);
      return TrajectoryPoint{0.0, {28.0 + way * way, across + way, 0.0}, 2.0 * way, 2.0, 0.0};
    });
    return detect(CollisionType::kLaneChange).manoeuvre;
  };
  EXPECT_EQ(movesOffFrom(-2.2), Manoeuvre::kPullOut) << "parked at the edge of the lane";
  EXPECT_NE(movesOffFrom(-0.3), Manoeuvre::kPullOut) << "waits in traffic";
}

TEST_F(ManoeuvreTest, DetectsCentreLineCrossingAndOvertaking) {
  road(twoLaneRoad());
  ego({0.0, 0.0, 0.0}, 8.0);
  attacker([](double t) {
    const double y = 3.5 - std::max(0.0, t - 2.0);
    return TrajectoryPoint{0.0, {64.0 - 8.0 * t, y, M_PI}, 8.0, 0.0, 0.0};
  });
  EXPECT_EQ(detect(CollisionType::kOppositeDirection).manoeuvre, Manoeuvre::kCentreLineCrossing);
  future_.agents = {futureTrack("slow", kCarSize, {40.0, 3.5, M_PI}, 4.0)};
  EXPECT_EQ(detect(CollisionType::kOppositeDirection).manoeuvre, Manoeuvre::kOvertaking);
}

TEST_F(ManoeuvreTest, DetectsStraightAndTurningCrossings) {
  road(fourWayJunction());
  ego({-32.0, -1.75, 0.0}, 8.0);
  attacker([](double t) {
    return TrajectoryPoint{0.0, {-1.75, 32.0 - 8.0 * t, -M_PI_2}, 8.0, 0.0, 0.0};
  });
  EXPECT_EQ(detect(CollisionType::kJunctionCrossing).manoeuvre, Manoeuvre::kStraightCrossing);
  attacker([](double t) {
    const double turn = std::clamp(0.4 * (t - 2.0), 0.0, 1.0);
    return TrajectoryPoint{
        0.0, {4.0 - t, 8.0 - 2.0 * t, -M_PI_2 + turn}, 2.0, 0.0, t > 2.0 ? 0.2 : 0.0};
  });
  const DetectedManoeuvre found = detect(CollisionType::kJunctionCrossing);
  EXPECT_EQ(found.manoeuvre, Manoeuvre::kTurnIntoPath);
  EXPECT_NEAR(found.begin, kNow + 2.0, 0.15);
  EXPECT_EQ(detect(CollisionType::kLtap).manoeuvre, Manoeuvre::kTurnAcrossPath);
}

}  // namespace
}  // namespace forge
