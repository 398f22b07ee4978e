#include "collision_forge/planner_test/planners/pdm_scorer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

/// The ego on the right lane of the three-lane road, its middle at x = 0, 4 s of motions.
class PdmScoring : public testing::Test {
 protected:
  /// Straight on from `middle` at a constant speed.
  PdmMotion straight(double speed, const Pose2& middle = {}) const {
    PdmMotion motion;
    for (int i = 0; i <= 40; ++i) {
      const OrientedBox box{compose(middle, {0.1 * speed * i, 0.0, 0.0}), ego_.size};
      motion.boxes.push_back(box);
      motion.states.push_back({rearAxleOf(box.center, ego_.center_offset), speed, 0.0, 0.0});
    }
    return motion;
  }

  /// What the motion is worth among these agents.
  PdmScore scoreOf(const PdmMotion& motion, const std::vector<Track>& agents = {}) {
    return scoresOf({motion}, agents).front();
  }

  std::vector<PdmScore> scoresOf(const std::vector<PdmMotion>& motions,
                                 const std::vector<Track>& agents = {}) const {
    std::set<std::string> ignored;
    const PdmForecast forecast(agents, {{}, ego_.size}, 0.1, 80, pdm().agents, ignored);
    return PdmScorer({forecast, map_, way_, comfort_}, pdm().scoring).score(motions);
  }

  static const PdmOptions& pdm() { return shippedConfig().planners.pdm; }
  static PdmArea lane(double y, bool is_on_route) {
    return {{{-200.0, y - 1.75}, {400.0, y - 1.75}, {400.0, y + 1.75}, {-200.0, y + 1.75}},
            is_on_route,
            {}};
  }

  const EgoVehicle ego_ = shippedConfig().ego_vehicle;
  const PdmMap map_{{lane(0.0, true), lane(3.5, true), lane(7.0, false)}, {}};
  const PdmPath way_{std::vector<Pose2>{{-200.0, 0.0, 0.0}, {400.0, 0.0, 0.0}}};
  const PdmComfort comfort_{41, 0.1, pdm().scoring.comfort};
};

TEST_F(PdmScoring, HittingACarInFrontIsAtFault) {
  const PdmScore score = scoreOf(straight(10.0), {agentAt("lead", {30.0, 0.0, 0.0}, 2.0)});
  EXPECT_EQ(score.collision, 0.0);
  ASSERT_TRUE(score.collision_time);
  // 30 m less half of both lengths, at 8 m/s.
  EXPECT_NEAR(*score.collision_time, (30.0 - 0.5 * (4.6 + ego_.size.length)) / 8.0, 0.1);
}

TEST_F(PdmScoring, WhoStaysAwayIsNoCollision) {
  const PdmScore score = scoreOf(straight(10.0), {agentAt("lead", {30.0, 0.0, 0.0}, 9.0),
                                                  agentAt("beside", {0.0, 3.5, 0.0}, 10.0)});
  EXPECT_EQ(score.collision, 1.0);
  EXPECT_FALSE(score.collision_time);
}

TEST_F(PdmScoring, AStaticObjectCostsHalf) {
  const Track cone = agentAt("cone", {20.0, 0.0, 0.0}, 0.0, {0.5, 0.5}, AgentClass::kStaticObject);
  EXPECT_EQ(scoreOf(straight(10.0), {cone}).collision, 0.5);
  EXPECT_EQ(scoreOf(straight(10.0), {cone, agentAt("lead", {30.0, 0.0, 0.0}, 0.0)}).collision, 0.0);
}

TEST_F(PdmScoring, BeingHitFromBehindIsNoFault) {
  EXPECT_EQ(scoreOf(straight(5.0), {agentAt("rear", {-20.0, 0.0, 0.0}, 15.0)}).collision, 1.0);
}

TEST_F(PdmScoring, AStandingEgoIsNeverAtFault) {
  EXPECT_EQ(scoreOf(straight(0.0), {agentAt("oncoming", {20.0, 0.0, M_PI}, 10.0)}).collision, 1.0);
  EXPECT_EQ(scoreOf(straight(1.0), {agentAt("oncoming", {20.0, 0.0, M_PI}, 10.0)}).collision, 0.0);
}

TEST_F(PdmScoring, AStandingAgentIsHitAtFaultEvenWithTheSide) {
  // Drawn sideways onto the ego's flank: only the side touches.
  PdmMotion motion = straight(5.0);
  for (std::size_t i = 0; i <= 40; ++i) {
    motion.boxes[i].center.y = 0.03 * static_cast<double>(i);
    motion.states[i].rear_axle.y = motion.boxes[i].center.y;
  }
  const Pose2 beside{10.0, 2.6, 0.0};
  const BoxSize bus{40.0, 1.9};
  EXPECT_EQ(scoreOf(motion, {agentAt("bus", beside, 0.0, bus)}).collision, 0.0);
}

TEST_F(PdmScoring, AHitOnTheSideIsAtFaultOnlyAcrossLanesOrOffRoad) {
  // A car from the right runs into the ego's flank, behind its front, ahead of its rear axle.
  const auto hit_at = [&](double y) {
    const Track crossing = agentAt("crossing", {10.3, y - 10.0, 0.5 * M_PI}, 6.5, {4.0, 1.0});
    return scoreOf(straight(10.0, {0.0, y, 0.0}), {crossing}).collision;
  };
  EXPECT_EQ(hit_at(0.0), 1.0);
  EXPECT_EQ(hit_at(1.75), 0.0);   // across two lanes
  EXPECT_EQ(hit_at(-1.75), 0.0);  // half on the verge
}

TEST_F(PdmScoring, WhoWasTouchedWithoutFaultIsLetAlone) {
  // Overtakes through the ego from behind, then brakes in front of it: counted once, no fault.
  PdmMotion motion = straight(5.0);
  for (std::size_t i = 20; i <= 40; ++i) motion.boxes[i].center.x += 0.5 * (i - 20.0);
  EXPECT_EQ(scoreOf(motion, {agentAt("rear", {-8.0, 0.0, 0.0}, 7.5)}).collision, 1.0);
}

TEST_F(PdmScoring, LeavingTheDrivableAreaRulesOut) {
  EXPECT_EQ(scoreOf(straight(10.0)).drivable_area, 1.0);
  EXPECT_EQ(scoreOf(straight(10.0, {0.0, -0.8, 0.0})).drivable_area, 1.0);
  EXPECT_EQ(scoreOf(straight(10.0, {0.0, -1.0, 0.0})).drivable_area, 0.0);
  EXPECT_EQ(scoreOf(straight(10.0, {0.0, 0.0, -0.1})).drivable_area, 0.0);
}

TEST_F(PdmScoring, DrivingOffTheRoutesLanesCostsByTheLongestRun) {
  const Pose2 oncoming{0.0, 7.0, 0.0};
  EXPECT_EQ(scoreOf(straight(10.0)).driving_direction, 1.0);
  EXPECT_EQ(scoreOf(straight(10.0, {0.0, 3.5, 0.0})).driving_direction, 1.0);
  EXPECT_EQ(scoreOf(straight(0.49, oncoming)).driving_direction, 1.0);
  EXPECT_EQ(scoreOf(straight(0.51, oncoming)).driving_direction, 0.5);
  EXPECT_EQ(scoreOf(straight(1.49, oncoming)).driving_direction, 0.5);
  EXPECT_EQ(scoreOf(straight(1.51, oncoming)).driving_direction, 0.0);
}

TEST_F(PdmScoring, ARunThatIsInterruptedStartsAnew) {
  PdmMotion motion = straight(0.7, {0.0, 7.0, 0.0});  // 2.8 m in all
  motion.boxes[20].center.y = 3.5;
  for (std::size_t i = 0; i <= 40; ++i) motion.boxes[i].center.x = 0.07 * static_cast<double>(i);
  EXPECT_EQ(scoreOf(straight(0.7, {0.0, 7.0, 0.0})).driving_direction, 0.5);
  motion.boxes[21].center.y = 3.5;
  EXPECT_EQ(scoreOf(motion).driving_direction, 0.5);  // going back is 3.5 m long
  motion.boxes[21].center.y = 7.0;
  for (std::size_t i = 21; i <= 40; ++i) motion.boxes[i].center.y = 3.5;
  EXPECT_EQ(scoreOf(motion).driving_direction, 1.0);
}

TEST_F(PdmScoring, TimeToCollisionLooksAheadOnTheSameSpeed) {
  // 0.9 s after the last state, 4.9 s from now, the lead is seen where it is after 4.8 s.
  const auto at = [&](double lead_speed) {
    const double gap = 9.5 + 0.5 * (4.6 + ego_.size.length);
    return scoreOf(straight(10.0), {agentAt("lead", {gap, 0.0, 0.0}, lead_speed)});
  };
  EXPECT_EQ(at(8.25).time_to_collision, 1.0);  // 49 - 4.8 * 8.25 = 9.4
  EXPECT_EQ(at(8.20).time_to_collision, 0.0);  // 49 - 4.8 * 8.20 = 9.64
  EXPECT_NEAR(*at(8.20).ttc_time, 4.0, 1e-9);
  EXPECT_EQ(at(8.20).collision, 1.0);
}

TEST_F(PdmScoring, TimeToCollisionMindsWhoIsBesideInSeveralLanesAlone) {
  // Drives into the flank of a slow ego.
  const auto hit_at = [&](double y) {
    const Track crossing = agentAt("crossing", {0.0, y - 6.0, 0.5 * M_PI}, 2.0, {4.0, 1.0});
    return scoreOf(straight(1.0, {0.0, y, 0.0}), {crossing}).time_to_collision;
  };
  EXPECT_EQ(hit_at(0.0), 1.0);
  EXPECT_EQ(hit_at(1.75), 0.0);
}

TEST_F(PdmScoring, TimeToCollisionDoesNotMindWhoStaysBehind) {
  EXPECT_EQ(scoreOf(straight(8.0), {agentAt("rear", {-8.0, 0.0, 0.0}, 8.5)}).time_to_collision,
            1.0);
}

TEST_F(PdmScoring, AStandingEgoHasTime) {
  const Track lead = agentAt("lead", {4.5, 0.0, 0.0}, -0.2);
  EXPECT_EQ(scoreOf(straight(0.0), {lead}).time_to_collision, 1.0);
  EXPECT_EQ(scoreOf(straight(0.2), {lead}).time_to_collision, 0.0);
}

TEST_F(PdmScoring, ComfortIsThatOfTheMotion) {
  PdmMotion motion = straight(10.0);
  EXPECT_EQ(scoreOf(motion).comfort, 1.0);
  for (BicycleState& state : motion.states) state.acceleration = -5.0;
  EXPECT_EQ(scoreOf(motion).comfort, 0.0);
}

TEST_F(PdmScoring, ProgressIsMeasuredAlongTheCentreline) {
  EXPECT_NEAR(scoreOf(straight(10.0)).driven, 40.0, 1e-6);
  EXPECT_NEAR(scoreOf(straight(10.0, {0.0, 0.0, 0.5})).driven, 40.0 * std::cos(0.5), 1e-6);
  EXPECT_EQ(scoreOf(straight(10.0, {0.0, 0.0, M_PI})).driven, 0.0);
}

TEST_F(PdmScoring, TheTotalIsTheProductTimesTheWeightedMean) {
  // The faster one hits the cone: half its way counts, half its total.
  const Track cone = agentAt("cone", {39.0, 0.0, 0.0}, 0.0, {0.5, 0.5}, AgentClass::kStaticObject);
  const std::vector<PdmScore> scores = scoresOf({straight(5.0), straight(10.0)}, {cone});
  ASSERT_EQ(scores.size(), 2U);
  EXPECT_NEAR(scores[0].progress, 1.0, 1e-9);
  EXPECT_NEAR(scores[0].total, 1.0, 1e-9);
  EXPECT_NEAR(scores[1].progress, 1.0, 1e-9);
  EXPECT_EQ(scores[1].time_to_collision, 0.0);
  EXPECT_NEAR(scores[1].total, 0.5 * (5.0 + 0.0 + 2.0) / 12.0, 1e-9);
}

TEST_F(PdmScoring, ProgressIsRelativeToTheFarthestThatIsNotRuledOut) {
  const Track lead = agentAt("lead", {30.0, 0.0, 0.0}, 0.0);
  const std::vector<PdmScore> scores =
      scoresOf({straight(3.0), straight(5.0), straight(15.0)}, {lead});
  EXPECT_NEAR(scores[0].progress, 0.6, 1e-6);
  EXPECT_NEAR(scores[1].progress, 1.0, 1e-6);
  EXPECT_EQ(scores[2].total, 0.0);
}

TEST_F(PdmScoring, WhereNobodyGetsOnProgressIsTheSame) {
  const std::vector<PdmScore> scores = scoresOf({straight(0.0), straight(0.02)}, {});
  EXPECT_EQ(scores[0].progress, 1.0);
  EXPECT_EQ(scores[1].progress, 1.0);
}

}  // namespace
}  // namespace forge
