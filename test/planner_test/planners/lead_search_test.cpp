#include "collision_forge/planner_test/planners/lead_search.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

const Polyline kStraight({{-50.0, 0.0}, {100.0, 0.0}});

std::optional<Lead> leadOf(const std::vector<Track>& others, double margin = 0.0) {
  return findLead({kStraight, 50.0, kEgoSize}, kEgoId, others, {40.0, margin});
}

Track carAt(const std::string& id, const Pose2& pose, double speed = 0.0) {
  return pastTrack(id, kCarSize, pose, speed);
}

TEST(LeadSearch, ReturnsTheGapFromBumperToBumper) {
  const auto lead = leadOf({carAt("ahead", {20.0, 0.0, 0.0}, 3.0)});
  ASSERT_TRUE(lead);
  EXPECT_EQ(lead->id, "ahead");
  EXPECT_NEAR(lead->gap, 20.0 - 0.5 * (kEgoSize.length + kCarSize.length), 1e-9);
  EXPECT_NEAR(lead->speed, 3.0, 1e-9);
}

TEST(LeadSearch, ACrossingCarLeadsAtItsFlank) {
  const auto lead = leadOf({carAt("crossing", {20.0, 1.0, M_PI_2}, 8.0)});
  ASSERT_TRUE(lead);
  EXPECT_NEAR(lead->gap, 20.0 - 0.5 * (kEgoSize.length + kCarSize.width), 1e-9);
  EXPECT_NEAR(lead->speed, 0.0, 1e-9);
}

TEST(LeadSearch, IgnoresAgentsBesideBehindOrTooFar) {
  const double beside = 0.5 * (kEgoSize.width + kCarSize.width) + 0.1;
  EXPECT_FALSE(leadOf({carAt("beside", {20.0, beside, 0.0})}));
  EXPECT_TRUE(leadOf({carAt("beside", {20.0, beside, 0.0})}, 0.2));
  EXPECT_FALSE(leadOf({carAt("behind", {-10.0, 0.0, 0.0})}));
  EXPECT_FALSE(leadOf({carAt("far", {46.0, 0.0, 0.0})}));
  EXPECT_TRUE(leadOf({carAt("within", {44.0, 0.0, 0.0})}));
  EXPECT_FALSE(leadOf({carAt(kEgoId, {20.0, 0.0, 0.0})}));
}

TEST(LeadSearch, FollowsABend) {
  // A quarter circle of 20 m to the left; the car stands at its end.
  std::vector<Vector2> arc;
  for (int i = 0; i <= 90; ++i) {
    const double angle = i * M_PI / 180.0;
    arc.emplace_back(20.0 * std::sin(angle), 20.0 - 20.0 * std::cos(angle));
  }
  const Polyline path(arc);
  const auto lead =
      findLead({path, 0.0, kEgoSize}, kEgoId, {carAt("around", {20.0, 20.0, M_PI_2})}, {40.0, 0.0});
  ASSERT_TRUE(lead);
  EXPECT_NEAR(lead->gap, 10.0 * M_PI - 0.5 * (kEgoSize.length + kCarSize.length), 0.3);
}

}  // namespace
}  // namespace forge
