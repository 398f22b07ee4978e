#include "collision_forge/attack/search/arrival_sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/placement.h"

namespace forge {
namespace {

constexpr double kTta = 4.0;

/// A car behind and to the left of an ego that drives at 9, 10 or 11 m/s.
class Arrivals : public testing::Test {
 protected:
  /// For the pattern only.
  void aimAt(CollisionType type, const Pose2& offset, double ego_x = 40.0, double speed = 12.0) {
    request_.type = type;
    patterns_ = {{type, "beside", kNow + kTta, {{ego_x, 0.0, 0.0}, kEgoSize}, offset, speed}};
    contenders_ = contendersOf(input_, options_, options_.verification.limits, 46);
    sampler_ =
        std::make_unique<ArrivalSampler>(input_, options_, options_.verification.limits, random_);
  }
  const Contender& contender() const { return *contenders_.at(0); }
  const Aim& aim() const { return contender().aims.at(0); }
  /// Attacker's pose in the ego's frame at the end of the lead.
  Pose2 seenFromEgo(const AimedArrival& aimed) const {
    const Pose2 contact = compose(aimed.arrival.pose, {aimed.lead * aimed.arrival.speed, 0.0, 0.0});
    return relativeTo(sampler_->egoAt(aimed.ego, aimed.contact), contact);
  }

  AttackOptions options_ = shippedOptions();
  std::shared_ptr<LaneMap> map_ = twoLaneRoad();
  Snapshot snapshot_ = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0),
                                  {pastTrack("beside", kCarSize, {-10.0, 3.5, 0.0}, 10.0)}, map_);
  std::vector<Track> tracks_ = {futureTrack(kEgoId, kEgoSize, {}, 9.0),
                                futureTrack(kEgoId, kEgoSize, {}, 10.0),
                                futureTrack(kEgoId, kEgoSize, {}, 11.0)};
  std::vector<const Track*> egos_ = {&tracks_[0], &tracks_[1], &tracks_[2]};
  Future future_;
  std::vector<CollisionPattern> patterns_;
  CollisionRequest request_ = requestFor();
  LaneIndex lanes_{map_};
  SearchInput input_{snapshot_, future_, egos_, patterns_, request_, lanes_};
  Random random_{1};
  std::vector<std::unique_ptr<Contender>> contenders_;
  std::unique_ptr<ArrivalSampler> sampler_;
};

const Pose2 kBehindLeft = attackerOffset(kEgoSize, kCarSize, Side::kRear, -0.2, 0.9, 0.0);

TEST_F(Arrivals, AtThePatternUseItsBoxItsTimeAndItsFuture) {
  aimAt(CollisionType::kLaneChange, kBehindLeft, 43.0);
  const AimedArrival own = sampler_->own(contender(), aim(), false);
  EXPECT_EQ(own.ego, 2U);
  EXPECT_EQ(own.contact, kTta);
  EXPECT_EQ(own.lead, 0.0);
  EXPECT_EQ(own.arrival.time, kTta);
  EXPECT_EQ(own.arrival.speed, 12.0);
  EXPECT_NEAR(own.arrival.pose.x, 44.0 + kBehindLeft.x, 1e-3);
  EXPECT_NEAR(own.arrival.pose.y, kBehindLeft.y, 1e-3);
  EXPECT_NEAR(own.arrival.pose.yaw, -0.2, 1e-9);
}

TEST_F(Arrivals, AtThePatternUseTheSteadySpeedOnRequest) {
  aimAt(CollisionType::kLaneChange, kBehindLeft);
  const AimedArrival own = sampler_->own(contender(), aim(), true);
  const double distance = (own.arrival.pose.position() - Vector2(-10.0, 3.5)).norm();
  EXPECT_NEAR(0.5 * (10.0 + own.arrival.speed) * kTta, distance, 1e-6);
}

TEST_F(Arrivals, AreWithinTheTimeTolerance) {
  aimAt(CollisionType::kLaneChange, kBehindLeft);
  patterns_[0].time = kNow + 9.0;
  EXPECT_EQ(sampler_->own(contender(), aim(), false).contact, sampler_->latest());
  patterns_[0].time = kNow + 1.0;
  EXPECT_EQ(sampler_->own(contender(), aim(), false).contact, sampler_->earliest());
  EXPECT_NEAR(sampler_->latest() - kTta, request_.crash.time_tolerance, 0.1);
  for (int i = 0; i < 200; ++i) {
    AimedArrival aimed = sampler_->wide(contender(), aim(), true);
    sampler_->move(aimed, 3.0);
    EXPECT_GE(aimed.contact, sampler_->earliest());
    EXPECT_LE(aimed.contact, sampler_->latest());
    EXPECT_GT(aimed.arrival.time, 0.0);
  }
}

TEST_F(Arrivals, SpreadAlongTheTouchedSideOverAllHeadingsOfTheType) {
  aimAt(CollisionType::kLaneChange,
        attackerOffset(kEgoSize, kCarSize, Side::kLeft, -0.3, 0.2, 0.0));
  const TypeDefinition& type = request_.bands();
  double least = 0.0, most = 0.0, foremost = -9.0, rearmost = 9.0;
  bool egos[3] = {};
  for (int i = 0; i < 1000; ++i) {
    const AimedArrival aimed = sampler_->wide(contender(), aim(), true);
    const Pose2 offset = seenFromEgo(aimed);
    EXPECT_GT(offset.y, 0.0);
    EXPECT_LE(offset.yaw, -type.min_heading + 1e-9) << "to the ego's side";
    EXPECT_GE(offset.yaw, -type.max_heading - 1e-9);
    most = i == 0 ? offset.yaw : std::max(most, offset.yaw);
    least = std::min(least, offset.yaw);
    foremost = std::max(foremost, offset.x);
    rearmost = std::min(rearmost, offset.x);
    egos[aimed.ego] = true;
  }
  EXPECT_NEAR(least, -type.max_heading, 0.01);
  EXPECT_NEAR(most, -type.min_heading, 0.01);
  EXPECT_NEAR(foremost, 0.45 * kEgoSize.length, 0.05);
  EXPECT_NEAR(rearmost, -0.45 * kEgoSize.length, 0.05);
  EXPECT_TRUE(egos[0] && egos[1] && egos[2]);
}

TEST_F(Arrivals, ShiftInTheEgosFrame) {
  aimAt(CollisionType::kLaneChange, kBehindLeft);
  AimedArrival aimed = sampler_->own(contender(), aim(), true);
  const Pose2 before = seenFromEgo(aimed);
  sampler_->shift(aimed, {0.4, -0.1, 0.05});
  const Pose2 after = seenFromEgo(aimed);
  EXPECT_NEAR(after.x - before.x, 0.4, 1e-9);
  EXPECT_NEAR(after.y - before.y, -0.1, 1e-9);
  EXPECT_NEAR(after.yaw - before.yaw, 0.05, 1e-9);
}

TEST_F(Arrivals, RejectAnAttackerThatCannotReachInTime) {
  aimAt(CollisionType::kLaneChange, kBehindLeft);
  EXPECT_TRUE(sampler_->canReach(contender()));
  snapshot_.agents[0] = pastTrack("beside", kCarSize, {-150.0, 3.5, 0.0}, 10.0);
  aimAt(CollisionType::kLaneChange, kBehindLeft);
  EXPECT_FALSE(sampler_->canReach(contender()));
}

}  // namespace
}  // namespace forge
