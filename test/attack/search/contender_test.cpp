#include "collision_forge/attack/search/contender.h"

#include <gtest/gtest.h>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/placement.h"

namespace forge {
namespace {

constexpr int kPoints = 46;

/// The ego drives east on the right one of two lanes, one other drives behind it, one stands on the
/// left lane and one off the road.
class Contenders : public testing::Test {
 protected:
  Contenders()
      : snapshot_(snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                             {pastTrack("behind", kCarSize, {-20.0, 0.0, 0.0}, 12.0),
                              pastTrack("standing", kCarSize, {15.0, 3.5, 0.0}, 0.0),
                              pastTrack("away", kCarSize, {0.0, 60.0, 0.0}, 5.0)},
                             map_)),
        lanes_(map_) {
    request_.tta = 4.0;
  }

  std::vector<std::unique_ptr<Contender>> of(const std::vector<std::string>& attackers) {
    std::vector<CollisionPattern> patterns(attackers.size());
    for (std::size_t i = 0; i < attackers.size(); ++i) patterns[i].attacker_id = attackers[i];
    return of(patterns, {&slow_});
  }
  std::vector<std::unique_ptr<Contender>> of(const std::vector<CollisionPattern>& patterns,
                                             const std::vector<const Track*>& egos) {
    const Future future;
    return contendersOf({snapshot_, future, egos, patterns, request_, lanes_}, options_,
                        options_.verification.limits, kPoints);
  }

  const Track slow_ = futureTrack(kEgoId, kEgoSize, {}, 5.0);
  const Track fast_ = futureTrack(kEgoId, kEgoSize, {}, 10.0);
  AttackOptions options_ = shippedOptions();
  std::shared_ptr<LaneMap> map_ = twoLaneRoad();
  Snapshot snapshot_;
  LaneIndex lanes_;
  CollisionRequest request_ = requestFor();
};

TEST_F(Contenders, AreTheVehiclesOfThePatternsEachOnceInTheirOrder) {
  const auto contenders = of({"standing", "behind", "standing", "nobody"});
  ASSERT_EQ(contenders.size(), 2U);
  EXPECT_EQ(contenders[0]->track, &snapshot_.agents[1]);
  EXPECT_EQ(contenders[1]->track, &snapshot_.agents[0]);
}

TEST_F(Contenders, AreNoMoreThanConfigured) {
  options_.search.max_attackers = 1;
  const auto contenders = of({"behind", "standing"});
  ASSERT_EQ(contenders.size(), 1U);
  EXPECT_EQ(contenders[0]->track->id, "behind");
}

TEST_F(Contenders, DriveFreelyAndAlongTheirLanes) {
  const auto contenders = of({"behind", "away"});
  EXPECT_FALSE(contenders[0]->paths.empty());
  EXPECT_EQ(contenders[0]->quintics.size(), 1 + contenders[0]->paths.size());
  EXPECT_TRUE(contenders[1]->paths.empty());
  EXPECT_EQ(contenders[1]->quintics.size(), 1U);
  options_.search.lane_paths = 0;
  EXPECT_EQ(of({"behind"})[0]->quintics.size(), 1U);
}

TEST_F(Contenders, StartFromTheirMotionNow) {
  const auto contenders = of({"behind", "standing"});
  EXPECT_NEAR(contenders[0]->start.motion.speed, 12.0, 1e-6);
  EXPECT_EQ(contenders[0]->start.points, kPoints);
  EXPECT_EQ(contenders[0]->start.now, snapshot_.now);
  EXPECT_EQ(contenders[1]->start.motion.acceleration, 0.0);
  options_.verification.limits.max_speed = 8.0;
  EXPECT_EQ(of({"behind"})[0]->start.motion.speed, 8.0);
}

TEST_F(Contenders, AimAtTheirPatternsInTheirOrder) {
  std::vector<CollisionPattern> patterns(3);
  patterns[0] = {CollisionType::kRearEnd, "behind", kNow + 4.0, {}, {-6.0, 0.3, 0.1}, 9.0};
  patterns[1] = {CollisionType::kRearEnd, "standing", kNow + 4.0, {}, {5.0, 0.0, 0.0}, 9.0};
  patterns[2] = {CollisionType::kRearEnd, "behind", kNow + 4.0, {}, {0.0, 2.0, -0.3}, 9.0};
  const auto contenders = of(patterns, {&slow_});
  ASSERT_EQ(contenders.size(), 2U);
  ASSERT_EQ(contenders[0]->aims.size(), 2U);
  EXPECT_EQ(contenders[0]->aims[0].pattern, &patterns[0]);
  EXPECT_EQ(contenders[0]->aims[1].pattern, &patterns[2]);
  ASSERT_EQ(contenders[1]->aims.size(), 1U);
  EXPECT_EQ(contenders[1]->aims[0].pattern, &patterns[1]);
  const Pose2 touching = touchingOffset(kEgoSize, kCarSize, patterns[2].attacker_offset);
  EXPECT_EQ(contenders[0]->aims[1].touching.y, touching.y);
}

TEST_F(Contenders, AimAtTheFutureInWhichTheEgoComesNearestToThePattern) {
  std::vector<CollisionPattern> patterns(2);
  patterns[0] = {CollisionType::kRearEnd, "behind", kNow + 4.0, {{38.0, 2.0, 0.1}, kEgoSize}, {}};
  patterns[1] = {CollisionType::kRearEnd, "behind", kNow + 4.0, {{22.0, 2.0, 0.1}, kEgoSize}, {}};
  const auto contenders = of(patterns, {&slow_, &fast_});
  EXPECT_EQ(contenders[0]->aims[0].ego, 1U) << "40 m in 4 s";
  EXPECT_EQ(contenders[0]->aims[1].ego, 0U) << "20 m";
}

}  // namespace
}  // namespace forge
