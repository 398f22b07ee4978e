#include "collision_forge/attack/search/request_constraints.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "attack/search/test_scenes.h"

namespace forge {
namespace {

/// A follower drives straight into the rear of an ego that drives straight on.
class RequestConstraintsTest : public testing::Test {
 protected:
  RequestConstraintsTest() {
    request_.mode = Mode::kReplay;
    request_.tta = 3.0;
    const Track track = futureTrack(attacker_.id, kCarSize, {-18.0, 0.0, 0.0}, 14.5);
    for (const AgentState& state : track.states) {
      points_.push_back({state.time, state.pose, 14.5, 0.0, 0.0});
    }
  }

  bool holds() {
    const std::vector<CollisionPattern> patterns;
    const LaneIndex lanes(map_);
    const SearchInput input{snapshot_, future_, egos_, patterns, request_, lanes};
    RequestConstraints asked(input, options_);
    named_ = asked.isNamed();
    return asked.holds(attacker_, points_, 1);
  }

  const AttackOptions options_ = shippedOptions();
  const std::shared_ptr<LaneMap> map_ = twoLaneRoad();
  const Track attacker_ = pastTrack("behind", kCarSize, {-18.0, 0.0, 0.0}, 14.5);
  const Snapshot snapshot_ = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 10.0), {attacker_}, map_);
  const Track driving_ = futureTrack(kEgoId, kEgoSize, {}, 10.0);
  const Track far_ = futureTrack(kEgoId, kEgoSize, {200.0, 0.0, 0.0}, 10.0);
  const std::vector<const Track*> egos_ = {&far_, &driving_};
  const Future future_;
  CollisionRequest request_ = believableRequestFor(CollisionType::kRearEnd);
  std::vector<TrajectoryPoint> points_;
  bool named_ = false;
};

TEST_F(RequestConstraintsTest, WithoutConstraintsEverythingHolds) {
  EXPECT_TRUE(holds());
  EXPECT_FALSE(named_);
}

TEST_F(RequestConstraintsTest, EveryConditionIsJudgedByItsMeasuredValue) {
  const double gap = 18.0 - 0.5 * (kEgoSize.length + kCarSize.length);
  const std::map<std::string, double> expected = {{"attacker_speed", 14.5},
                                                  {"deceleration", 0.0},
                                                  {"gap", gap},
                                                  {"headway", gap / 14.5},
                                                  {"lateral_speed", 0.0}};
  for (const RangeControl& control : kRangeControls) {
    const auto value = expected.find(control.name);
    if (value == expected.end()) continue;
    const double low = std::max(0.0, value->second - 0.01);
    request_.*control.asked = Range{low, value->second + 0.01};
    EXPECT_TRUE(holds()) << control.name;
    EXPECT_TRUE(named_);
    request_.*control.asked = Range{value->second + 0.01, value->second + 0.02};
    EXPECT_FALSE(holds()) << control.name;
    (request_.*control.asked).reset();
  }
  request_.impact_location = {0.4, 0.6};
  EXPECT_FALSE(holds()) << "the ego is hit at its rear";
}

TEST_F(RequestConstraintsTest, JudgesTheCrashInTheGivenFuture) {
  request_.ego_side = Side::kRear;
  EXPECT_TRUE(holds());
  EXPECT_TRUE(named_);
  request_.ego_side = Side::kFront;
  EXPECT_FALSE(holds());
  request_.ego_side.reset();
  request_.impact_speed = {4.0, 5.0};
  EXPECT_TRUE(holds());
  request_.impact_speed = {5.0, 6.0};
  EXPECT_FALSE(holds());
}

}  // namespace
}  // namespace forge
