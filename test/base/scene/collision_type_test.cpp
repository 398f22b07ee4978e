#include "collision_forge/base/scene/collision_type.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(CollisionType, TypeNamesAreReadBackInAnyCase) {
  for (const CollisionType type : kAllCollisionTypes) {
    EXPECT_EQ(collisionTypeFromString(toString(type)), type);
  }
  EXPECT_EQ(collisionTypeFromString("any"), CollisionType::kAny);
  EXPECT_EQ(collisionTypeFromString("Rear_End"), CollisionType::kRearEnd);
}

TEST(CollisionType, ShortTypeNamesAreThoseOfThePaper) {
  EXPECT_EQ(collisionTypeFromString("LC"), CollisionType::kLaneChange);
  EXPECT_EQ(collisionTypeFromString("OD"), CollisionType::kOppositeDirection);
  EXPECT_EQ(collisionTypeFromString("HO"), CollisionType::kOppositeDirection);
  EXPECT_EQ(collisionTypeFromString("RE"), CollisionType::kRearEnd);
  EXPECT_EQ(collisionTypeFromString("JC"), CollisionType::kJunctionCrossing);
  EXPECT_EQ(collisionTypeFromString("LTAP"), CollisionType::kLtap);
  EXPECT_EQ(collisionTypeFromString("ltap"), CollisionType::kLtap);
}

TEST(CollisionType, HeadOnIsTheOppositeDirection) {
  EXPECT_EQ(collisionTypeFromString("head_on"), CollisionType::kOppositeDirection);
}

TEST(CollisionType, AnyMeansEveryOtherType) {
  EXPECT_EQ(typesMeant(CollisionType::kAny),
            std::vector(std::begin(kAllCollisionTypes), std::end(kAllCollisionTypes)));
  EXPECT_EQ(typesMeant(CollisionType::kLtap), std::vector{CollisionType::kLtap});
}

}  // namespace
}  // namespace forge
