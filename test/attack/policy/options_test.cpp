#include "collision_forge/attack/policy/options.h"

#include <gtest/gtest.h>

#include "attack/policy/policy_scenes.h"

namespace forge {
namespace {

TEST(AdaptiveOptions, AreConsistentWithEachOtherAndTheSearch) {
  const AdaptiveOptions options = shippedAdaptive();
  const AttackOptions attack = shippedOptions();
  EXPECT_GE(options.period, attack.search.step - 1e-9) << "plans change at the points";
  EXPECT_LT(options.fairness.reaction_time, options.evade_time);
  EXPECT_GT(options.max_ego_speed, attack.verification.limits.max_speed);
  ASSERT_FALSE(options.drive_on.speed_shares.empty());
  EXPECT_EQ(options.drive_on.speed_shares.front(), 1.0) << "who can goes on as it does";
  EXPECT_EQ(options.drive_on.speed_shares.back(), 0.0) << "who must stops";
}

}  // namespace
}  // namespace forge
