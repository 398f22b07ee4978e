#include "collision_forge/attack/search/recorded_traffic.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// The ego drives 10 m/s along x and is at 0 at t0; an agent drives likewise 20 m ahead of it, in
/// the future on, too.
RecordedTraffic traffic() {
  Future future;
  future.ego = futureTrack(kEgoId, kEgoSize, {}, 10.0);
  future.agents = {futureTrack("ahead", kCarSize, {20.0, 0.0, 0.0}, 10.0)};
  return {snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                     {pastTrack("ahead", kCarSize, {20.0, 0.0, 0.0}, 10.0)}, emptyMap()),
          future, 4.0, 0.2};
}

TEST(RecordedTraffic, IsKnownFromTheFirstFrameToTheEnd) {
  EXPECT_EQ(traffic().firstInstant(), -18) << "3.5 s";
  EXPECT_EQ(traffic().lastInstant(), 20);
}

TEST(RecordedTraffic, TestsContactWithClearance) {
  const RecordedTraffic traffic = forge::traffic();
  // Of two cars of 4.6 m, 4.8 m apart: half a metre less of clearance on either side touches.
  EXPECT_TRUE(traffic.touches({10.0 + 4.8, 0.0, 0.0}, kCarSize, -5, 0.3));
  EXPECT_FALSE(traffic.touches({10.0 + 4.8, 0.0, 0.0}, kCarSize, -5, 0.1));
  EXPECT_TRUE(traffic.touches({40.0, 0.0, 0.0}, kCarSize, 10, 0.0)) << "as the future has it";
  EXPECT_FALSE(traffic.touches({20.0, 0.0, 0.0}, kCarSize, 10, 0.0));
}

TEST(RecordedTraffic, ContainsTheEgoUpToNowOnly) {
  EXPECT_TRUE(traffic().touches({-10.0, 0.0, 0.0}, kCarSize, -5, 0.0));
  EXPECT_FALSE(traffic().touches({10.0, 0.0, 0.0}, kCarSize, 5, 0.0));
  EXPECT_NEAR(traffic().distanceToEgo({-10.0, 30.0}, -5).value_or(0.0), 30.0, 1e-6);
  EXPECT_FALSE(traffic().distanceToEgo({-10.0, 30.0}, 5));
}

TEST(RecordedTraffic, OccludesPlacesBehindAVehicle) {
  EXPECT_TRUE(traffic().hides({50.0, 1.0}, 0));
  EXPECT_FALSE(traffic().hides({50.0, 10.0}, 0));
  EXPECT_FALSE(traffic().hides({15.0, 0.0}, 0)) << "before it";
}

}  // namespace
}  // namespace forge
