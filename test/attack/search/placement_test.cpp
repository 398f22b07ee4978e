#include "collision_forge/attack/search/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <utility>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

constexpr BoxSize kEgo{4.0, 2.0};
constexpr BoxSize kAttacker{5.0, 2.2};

Vector2 pushFrom(Side side) {
  switch (side) {
    case Side::kFront:
      return {-1.0, 0.0};
    case Side::kRear:
      return {1.0, 0.0};
    case Side::kLeft:
      return {0.0, -1.0};
    default:
      return {0.0, 1.0};
  }
}

OrientedBox moved(OrientedBox box, const Vector2& by) {
  box.center.x += by.x();
  box.center.y += by.y();
  return box;
}

using Placements = std::vector<std::pair<Side, double>>;

Placements placementsIn(CollisionType type, DrivingSide traffic,
                        Turning turning = Turning::kAttacker) {
  Placements placements;
  for (const Placement& placement : placementsOf(type, traffic, turning)) {
    placements.emplace_back(placement.side, placement.sign);
  }
  return placements;
}

TEST(PlacementsOf, FitTheTypeForBothDrivingSides) {
  for (const DrivingSide traffic : {DrivingSide::kRight, DrivingSide::kLeft}) {
    EXPECT_EQ(placementsIn(CollisionType::kRearEnd, traffic),
              (Placements{{Side::kRear, 0.0}, {Side::kFront, 0.0}}));
    EXPECT_EQ(placementsIn(CollisionType::kOppositeDirection, traffic),
              (Placements{{Side::kFront, 0.0}}));
    EXPECT_EQ(placementsIn(CollisionType::kLaneChange, traffic),
              (Placements{{Side::kLeft, -1.0}, {Side::kRight, 1.0}}));
    EXPECT_EQ(
        placementsIn(CollisionType::kJunctionCrossing, traffic),
        (Placements{
            {Side::kLeft, -1.0}, {Side::kRight, 1.0}, {Side::kFront, -1.0}, {Side::kFront, 1.0}}));
  }
}

TEST(PlacementsOf, LtapComesFromTheSideOfOncomingTraffic) {
  EXPECT_EQ(placementsIn(CollisionType::kLtap, DrivingSide::kRight),
            (Placements{{Side::kLeft, -1.0}, {Side::kFront, -1.0}}));
  EXPECT_EQ(placementsIn(CollisionType::kLtap, DrivingSide::kLeft),
            (Placements{{Side::kRight, 1.0}, {Side::kFront, 1.0}}));
}

TEST(PlacementsOf, ATurningEgoIsHitOnTheOtherSide) {
  EXPECT_EQ(placementsIn(CollisionType::kLtap, DrivingSide::kRight, Turning::kEgo),
            placementsIn(CollisionType::kLtap, DrivingSide::kLeft));
  EXPECT_EQ(placementsIn(CollisionType::kLtap, DrivingSide::kLeft, Turning::kEgo),
            placementsIn(CollisionType::kLtap, DrivingSide::kRight));
}

TEST(PlacementsOf, KeepTheTypeAtTheNominalHeading) {
  const TypeDefinitions types = shippedCrash().types;
  for (const CollisionType type : kAllCollisionTypes) {
    for (const DrivingSide traffic : {DrivingSide::kRight, DrivingSide::kLeft}) {
      for (const Placement& placement : placementsOf(type, traffic)) {
        for (const double sign : {1.0, -1.0}) {
          if (placement.sign == -sign) continue;
          const double heading = wrapAngle(sign * types.at(type).nominal_heading);
          const Pose2 offset = attackerOffset(kEgo, kAttacker, placement.side, heading, 0.0, 0.0);
          EXPECT_TRUE(headingFits(offset.yaw, types.at(type))) << toString(type);
          EXPECT_TRUE(contactFits(type, offset, kEgo, kAttacker, traffic)) << toString(type);
        }
      }
    }
  }
}

TEST(AttackerOffset, ForAlignedBoxesIsHalfTheSidesMinusTheDepth) {
  const auto expect_offset = [](Side side, double heading, double slide, const Pose2& expected) {
    const Pose2 offset = attackerOffset(kEgo, kAttacker, side, heading, slide, 0.15);
    EXPECT_NEAR(offset.x, expected.x, 1e-9);
    EXPECT_NEAR(offset.y, expected.y, 1e-9);
    EXPECT_EQ(offset.yaw, expected.yaw);
  };
  expect_offset(Side::kFront, M_PI, 0.5, {4.35, 0.5, M_PI});
  expect_offset(Side::kRear, 0.0, -0.5, {-4.35, -0.5, 0.0});
  expect_offset(Side::kLeft, -M_PI_2, 0.5, {1.0, 3.35, -M_PI_2});
  expect_offset(Side::kRight, M_PI_2, -0.5, {-1.0, -3.35, M_PI_2});
}

TEST(AttackerOffset, OverlapsByTheDepthAlongThePushForAnyBoxes) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const BoxSize ego{1.0 + 12.0 * unit(random), 0.5 + 3.0 * unit(random)};
    const BoxSize attacker{1.0 + 12.0 * unit(random), 0.5 + 3.0 * unit(random)};
    const auto side = static_cast<Side>(i % 4);
    const double heading = M_PI * (2.0 * unit(random) - 1.0);
    const double slide = 2.0 * unit(random) - 1.0;
    const double depth = 0.3 * unit(random);
    const OrientedBox ego_box{{}, ego};
    const OrientedBox box{attackerOffset(ego, attacker, side, heading, slide, depth), attacker};
    EXPECT_EQ(box.center.yaw, heading);
    EXPECT_TRUE(overlaps(ego_box, moved(box, -(depth - 1e-6) * pushFrom(side)))) << i;
    EXPECT_FALSE(overlaps(ego_box, moved(box, -(depth + 1e-6) * pushFrom(side)))) << i;
    for (double back = depth + 0.05; back < 20.0; back += 0.25) {
      EXPECT_FALSE(overlaps(ego_box, moved(box, -back * pushFrom(side))))
          << i << ": a contact further out along the push";
    }
  }
}

TEST(TouchingOffset, IsOnTheLineToTheEgosCentreWhereTheBoxesJustTouch) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  for (int i = 0; i < 2000; ++i) {
    const Pose2 asked{8.0 * unit(random), 8.0 * unit(random), M_PI * unit(random)};
    const Pose2 offset = touchingOffset(kEgo, kAttacker, asked);
    EXPECT_EQ(offset.yaw, asked.yaw);
    EXPECT_NEAR(offset.x * asked.y, offset.y * asked.x, 1e-9);
    EXPECT_GT(offset.position().dot(asked.position()), 0.0);
    for (const auto& [factor, touches] : {std::pair(1.0 - 1e-6, true), {1.0 + 1e-6, false}}) {
      const Pose2 there{factor * offset.x, factor * offset.y, offset.yaw};
      EXPECT_EQ(overlaps({{}, kEgo}, {there, kAttacker}), touches) << i;
    }
  }
}

TEST(PlacementsAlong, ACrossingLaneIsHitAtItsOwnHeading) {
  const auto found = placementsAlong(-1.5, believableRequestFor(CollisionType::kJunctionCrossing),
                                     DrivingSide::kRight, 0.03, 0.6);
  ASSERT_EQ(found.size(), 2U) << "from the left or in front, heading to the right";
  for (const HeadedPlacement& placement : found) EXPECT_DOUBLE_EQ(placement.heading, -1.5);
  EXPECT_EQ(found[0].side, Side::kLeft);
  EXPECT_EQ(found[1].side, Side::kFront);
}

TEST(PlacementsAlong, HeadingsAreWithinTheBandAndNearTheLanes) {
  const CollisionRequest request = believableRequestFor(CollisionType::kLaneChange);
  const TypeDefinition& band = request.bands();
  const auto along = [&](double direction) {
    return placementsAlong(direction, request, DrivingSide::kRight, 0.03, 0.6);
  };
  const auto beside = along(0.0);
  ASSERT_EQ(beside.size(), 2U);
  EXPECT_EQ(beside[0].side, Side::kRight);
  EXPECT_DOUBLE_EQ(beside[0].heading, band.min_heading + 0.03);
  EXPECT_EQ(beside[1].side, Side::kLeft);
  EXPECT_DOUBLE_EQ(beside[1].heading, -band.min_heading - 0.03);
  EXPECT_TRUE(along(1.4).empty());
}

TEST(PlacementsAlong, KeepToTheRequestedSides) {
  CollisionRequest request = believableRequestFor(CollisionType::kAngleSameDirection);
  const auto sides = [&](double direction) {
    std::vector<Side> found;
    for (const HeadedPlacement& placement :
         placementsAlong(direction, request, DrivingSide::kRight, 0.03, 0.6)) {
      found.push_back(placement.side);
    }
    return found;
  };
  EXPECT_EQ(sides(-1.0), (std::vector{Side::kLeft, Side::kFront}));
  request.from_side = Side::kRight;
  EXPECT_TRUE(sides(-1.0).empty()) << "the lane comes from the left";
  EXPECT_EQ(sides(1.0), (std::vector{Side::kRight, Side::kFront}));
  request.ego_side = Side::kFront;
  EXPECT_EQ(sides(1.0), std::vector{Side::kFront});
}

}  // namespace
}  // namespace forge
