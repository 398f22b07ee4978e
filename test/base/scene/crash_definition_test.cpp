#include "collision_forge/base/scene/crash_definition.h"

#include <gtest/gtest.h>

#include <cmath>

namespace forge {
namespace {

constexpr BoxSize kEgo{4.0, 2.0};
constexpr BoxSize kAttacker{5.0, 2.2};
constexpr double kBit = 1e-6;  // to either side of a bound
constexpr DrivingSide kBothSides[] = {DrivingSide::kRight, DrivingSide::kLeft};

bool fits(CollisionType type, const Pose2& offset, DrivingSide side = DrivingSide::kRight) {
  return contactFits(type, offset, kEgo, kAttacker, side);
}

TEST(HeadingFits, WithinTheBandOnBothSidesEndsIncluded) {
  const TypeDefinition band{0.2, 0.5, 0.3, 1.0, 2.0};
  for (const double sign : {1.0, -1.0}) {
    EXPECT_FALSE(headingFits(sign * (0.2 - kBit), band));
    EXPECT_TRUE(headingFits(sign * 0.2, band));
    EXPECT_TRUE(headingFits(sign * 0.35, band));
    EXPECT_TRUE(headingFits(sign * 0.5, band));
    EXPECT_FALSE(headingFits(sign * (0.5 + kBit), band));
    EXPECT_FALSE(headingFits(sign * 1.5, band)) << "that is the approach band";
  }
}

TEST(ApproachFits, WithinTheBandOnBothSidesEndsIncluded) {
  const TypeDefinition band{0.2, 0.5, 0.3, 1.0, 2.0};
  for (const double sign : {1.0, -1.0}) {
    EXPECT_FALSE(approachFits(sign * (1.0 - kBit), band));
    EXPECT_TRUE(approachFits(sign * 1.0, band));
    EXPECT_TRUE(approachFits(sign * 2.0, band));
    EXPECT_FALSE(approachFits(sign * (2.0 + kBit), band));
    EXPECT_FALSE(approachFits(sign * 0.3, band)) << "that is the band at contact";
  }
}

TEST(ContactFits, ARearEndMeetsEndToEndWithEitherInFront) {
  for (const DrivingSide side : kBothSides) {
    for (const double x : {4.5, -4.5}) {
      for (const double y : {0.0, 1.9, -1.9}) {
        EXPECT_TRUE(fits(CollisionType::kRearEnd, {x, y, 0.0}, side)) << x << " " << y;
      }
    }
    for (const double y : {2.1, -2.1}) {
      EXPECT_FALSE(fits(CollisionType::kRearEnd, {0.0, y, 0.0}, side)) << "flank to flank";
      EXPECT_FALSE(fits(CollisionType::kRearEnd, {4.0, y, 0.0}, side)) << "flank to flank";
    }
  }
}

TEST(ContactFits, ARearEndEndsWhereTheBoxesAreFurtherApartAcrossThanAlong) {
  // Half lengths add up to 4.5 m, half widths to 2.1 m.
  for (const double x_sign : {1.0, -1.0}) {
    for (const double y_sign : {1.0, -1.0}) {
      for (const double gap : {-0.3, 0.0, 0.2}) {
        const double y = y_sign * (2.1 + gap);
        EXPECT_TRUE(fits(CollisionType::kRearEnd, {x_sign * (4.5 + gap + kBit), y, 0.0}));
        EXPECT_FALSE(fits(CollisionType::kRearEnd, {x_sign * (4.5 + gap - kBit), y, 0.0}));
      }
    }
  }
}

TEST(ContactFits, ARearEndUsesTheProjectionOfARotatedBox) {
  const double yaw = 0.17;
  const double reach_x = 2.0 + 2.5 * std::cos(yaw) + 1.1 * std::sin(yaw);
  const double reach_y = 1.0 + 2.5 * std::sin(yaw) + 1.1 * std::cos(yaw);
  for (const double sign : {1.0, -1.0}) {
    const auto at = [&](double x) {
      return fits(CollisionType::kRearEnd, {-x, reach_y, sign * yaw});
    };
    EXPECT_TRUE(at(reach_x + kBit));
    EXPECT_FALSE(at(reach_x - kBit));
  }
}

TEST(ContactFits, ALaneChangeComesFromBesideAndHeadsTowardsTheEgo) {
  for (const DrivingSide side : kBothSides) {
    for (const double sign : {1.0, -1.0}) {
      const auto at = [&](double y, double yaw) {
        return fits(CollisionType::kLaneChange, {0.5, sign * y, sign * yaw}, side);
      };
      EXPECT_TRUE(at(1.0, -0.2)) << "half the ego's width";
      EXPECT_FALSE(at(1.0 - kBit, -0.2));
      EXPECT_TRUE(at(2.0, -kBit));
      EXPECT_FALSE(at(2.0, 0.0));
      EXPECT_FALSE(at(2.0, kBit)) << "away from the ego";
    }
  }
}

TEST(ContactFits, AnLtapTurnedToTheLeftInRightHandTrafficAndMirrored) {
  for (const double y : {3.0, 0.0, -3.0}) {
    const auto at = [&](double yaw, DrivingSide side) {
      return fits(CollisionType::kLtap, {2.0, y, yaw}, side);
    };
    EXPECT_TRUE(at(-M_PI_2, DrivingSide::kRight));
    EXPECT_TRUE(at(-kBit, DrivingSide::kRight));
    EXPECT_FALSE(at(kBit, DrivingSide::kRight));
    EXPECT_FALSE(at(M_PI_2, DrivingSide::kRight));
    EXPECT_TRUE(at(M_PI_2, DrivingSide::kLeft));
    EXPECT_TRUE(at(kBit, DrivingSide::kLeft));
    EXPECT_FALSE(at(-kBit, DrivingSide::kLeft));
    EXPECT_FALSE(at(-M_PI_2, DrivingSide::kLeft));
  }
}

TEST(ContactFits, AnLtapOfTheEgoIsMirrored) {
  for (const DrivingSide side : kBothSides) {
    for (const double yaw : {2.0, -2.0}) {
      const Pose2 offset{2.0, 0.0, yaw};
      EXPECT_NE(contactFits(CollisionType::kLtap, offset, kEgo, kAttacker, side, Turning::kEgo),
                contactFits(CollisionType::kLtap, offset, kEgo, kAttacker, side));
    }
  }
}

TEST(ContactFits, ASideswipeIsWhatARearEndIsNot) {
  for (const double x : {4.6, 4.0, 0.0, -4.0, -4.6}) {
    const Pose2 offset{x, 2.1, 0.0};
    EXPECT_NE(fits(CollisionType::kSideswipeSameDirection, offset),
              fits(CollisionType::kRearEnd, offset))
        << x;
  }
}

TEST(ContactFits, AnAngleCrashTouchesAFlank) {
  const double yaw = 0.7;
  const CollisionType type = CollisionType::kAngleSameDirection;
  EXPECT_FALSE(fits(type, {4.45, 1.6, yaw})) << "its rear meets the ego's front";
  EXPECT_FALSE(fits(type, {-4.45, -1.6, yaw})) << "its front meets the ego's rear";
  EXPECT_TRUE(fits(type, {0.0, -3.4, yaw})) << "its front meets the ego's flank";
  EXPECT_TRUE(fits(CollisionType::kAngleOppositeDirection, {4.6, 0.0, M_PI - yaw}));
}

TEST(EgoTurns, ToTheLeftByMoreThanTheAttackerAndMirrored) {
  TypeDefinition band;
  band.max_heading = M_PI - 0.2;
  for (const auto& [side, left] :
       {std::pair(DrivingSide::kRight, 1.0), {DrivingSide::kLeft, -1.0}}) {
    const auto turns = [&, traffic = side](double ego_turn, double attacker_turn) {
      return egoTurns(CollisionType::kLtap, {ego_turn, attacker_turn, 0.0}, AgentClass::kCar, band,
                      traffic);
    };
    EXPECT_TRUE(turns(left * 0.3, 0.1));
    EXPECT_FALSE(turns(left * 0.19, 0.1)) << "less than the band leaves";
    EXPECT_FALSE(turns(-left * 0.3, 0.1)) << "to the other side";
    EXPECT_FALSE(turns(left * 0.3, -0.31)) << "the attacker turns more";
  }
}

TEST(EgoTurns, AtACrossingByThirtyDegreesAndMoreThanAVehicle) {
  const auto turns = [](double ego_turn, double attacker_turn) {
    return egoTurns(CollisionType::kAngleSameDirection, {ego_turn, attacker_turn, 0.7},
                    AgentClass::kCar, {}, DrivingSide::kRight);
  };
  for (const double side : {1.0, -1.0}) {
    EXPECT_TRUE(turns(side * 0.53, 0.5)) << side;
    EXPECT_FALSE(turns(side * 0.52, 0.0)) << side << ": below 30 degrees";
    EXPECT_FALSE(turns(side * 0.7, -0.71)) << side << ": the attacker turns more";
  }
}

TEST(EgoTurns, TowardsPeopleWhoCrossTheArm) {
  const auto turns = [](double ego_turn, double relative_heading) {
    return egoTurns(CollisionType::kJunctionCrossing, {ego_turn, 1.5, relative_heading},
                    AgentClass::kBicycle, {}, DrivingSide::kRight);
  };
  for (const double left : {1.0, -1.0}) {
    EXPECT_TRUE(turns(left * 1.4, -left * 1.5)) << "as the ego drove at t0";
    EXPECT_TRUE(turns(left * 1.4, left * 1.6)) << "towards where the ego was at t0";
    EXPECT_FALSE(turns(left * 0.8, -left * 1.5)) << "40 degrees to the ego's former direction";
    EXPECT_FALSE(turns(left * 0.4, left * 1.5)) << "the ego hardly turns";
  }
}

TEST(BandsOf, ATurningEgoAllowsAnyApproach) {
  CrashDefinition crash;
  crash.types[CollisionType::kJunctionCrossing] = {1.4, 1.7, 1.6, 0.8, 2.4};
  crash.ltap_ego_turns.min_heading = 1.75;
  const TypeDefinition turning = bandsOf(CollisionType::kJunctionCrossing, Turning::kEgo, crash);
  EXPECT_EQ(turning.min_heading, 1.4);
  EXPECT_TRUE(approachFits(0.0, turning));
  EXPECT_TRUE(approachFits(M_PI, turning));
  EXPECT_FALSE(
      approachFits(0.0, bandsOf(CollisionType::kJunctionCrossing, Turning::kAttacker, crash)));
  EXPECT_EQ(bandsOf(CollisionType::kLtap, Turning::kEgo, crash).min_heading, 1.75);
  EXPECT_THROW(bandsOf(CollisionType::kLtap, Turning::kAttacker, crash), std::out_of_range);
}

}  // namespace
}  // namespace forge
