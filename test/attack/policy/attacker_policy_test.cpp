#include "collision_forge/attack/policy/attacker_policy.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

TEST(AttackerPolicy, NamesAreReadAsTheyAreWritten) {
  for (const AttackerPhase phase :
       {AttackerPhase::kAttacking, AttackerPhase::kCommitted, AttackerPhase::kDrivingOn}) {
    EXPECT_EQ(attackerPhaseFromString(toString(phase)), phase);
  }
  EXPECT_FALSE(attackerPhaseFromString("sleeping"));
  for (const PolicyKind kind : {PolicyKind::kFixed, PolicyKind::kAdaptive}) {
    EXPECT_EQ(policyKindFromString(toString(kind)), kind);
  }
  EXPECT_FALSE(policyKindFromString("reckless"));
}

TEST(FixedAttacker, DrivesItsTrajectoryWhateverItObserves) {
  const AttackerTrajectory drive = straightDrive({0.0, 0.0, 0.0}, 10.0, 3.0);
  FixedAttacker attacker(drive);
  attacker.observe({kNow + 1.0, {500.0, 0.0, 0.0}, {}});
  ASSERT_EQ(attacker.trajectory().points.size(), drive.points.size());
  EXPECT_EQ(attacker.trajectory().points.back().pose.x, drive.points.back().pose.x);
  EXPECT_EQ(attacker.phase(), AttackerPhase::kCommitted);
  ASSERT_EQ(attacker.plans().size(), 1u);
  EXPECT_EQ(attacker.plans().front().points.size(), drive.points.size());
}

}  // namespace
}  // namespace forge
