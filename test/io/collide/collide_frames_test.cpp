#include "collision_forge/io/collide/collide_frames.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace forge {
namespace {

using testing::ElementsAre;

TEST(CollideFrames, FramesAtTwoHertzAreKept) {
  const std::vector<double> jittered = {0.0, 0.54, 1.0, 1.46, 2.5};
  EXPECT_TRUE(areCollideFrames(jittered));
  EXPECT_EQ(collideFrames(jittered), jittered);
}

TEST(CollideFrames, OfFasterFramesTheNearestToHalfSecondsAreKept) {
  EXPECT_THAT(collideFrames({0.0, 0.2, 0.41, 0.6, 0.8, 1.0, 1.3, 1.49}),
              ElementsAre(0.0, 0.41, 1.0, 1.49));
}

TEST(CollideFrames, TheGridIsHalfSecondsAroundNow) {
  EXPECT_THAT(collideGrid({0.0, 0.2505, 0.5, 0.75, 1.0}, 0.75, -1, 1),
              ElementsAre(0.2505, 0.75, 1.25));
}

}  // namespace
}  // namespace forge
