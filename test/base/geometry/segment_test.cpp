#include "collision_forge/base/geometry/segment.h"

#include <gtest/gtest.h>

namespace forge {
namespace {

TEST(NearestShare, IsTheFootOfThePerpendicular) {
  EXPECT_DOUBLE_EQ(nearestShare({1.0, 1.0}, {5.0, 1.0}, {2.0, 9.0}), 0.25);
}

TEST(NearestShare, IsAnEndBeyondTheSegment) {
  EXPECT_EQ(nearestShare({1.0, 1.0}, {5.0, 1.0}, {-2.0, 9.0}), 0.0);
  EXPECT_EQ(nearestShare({1.0, 1.0}, {5.0, 1.0}, {7.0, -9.0}), 1.0);
}

}  // namespace
}  // namespace forge
