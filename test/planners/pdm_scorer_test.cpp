#include "collision_forge/planners/pdm_scorer.h"

#include <gtest/gtest.h>

#include <optional>

#include "planners/planner_scenes.h"

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

  const PdmScorer& scorer(const std::vector<Track>& agents) {
    std::set<std::string> ignored;
    forecast_.emplace(agents, OrientedBox{{}, ego_.size}, 0.1, 80, pdm().agents, ignored);
    scorer_.emplace(
        PdmSurroundings{
            *forecast_, *lanes_, way_, way_.project({0.0, 0.0}).sample, ego_, bicycle_, {}},
        pdm().map_radius, pdm().scoring);
    return *scorer_;
  }

  static const PdmOptions& pdm() { return shippedConfig().planners.pdm; }

  const EgoVehicle ego_ = shippedConfig().ego_vehicle;
  const std::shared_ptr<const LaneIndex> lanes_ = threeLaneRoad();
  const SampledWay way_{Polyline(routeAlong(*lanes_, 0))};
  const KinematicBicycle bicycle_{shippedConfig().planners.car};
  std::optional<PdmForecast> forecast_;
  std::optional<PdmScorer> scorer_;
};

TEST_F(PdmScoring, HittingACarInFrontIsAtFault) {
  const PdmCollision collision =
      scorer({agentAt("lead", {30.0, 0.0, 0.0}, 2.0)}).collision(straight(10.0));
  EXPECT_EQ(collision.score, 0.0);
  ASSERT_TRUE(collision.time);
  // 30 m less half of both lengths, at 8 m/s.
  EXPECT_NEAR(*collision.time, (30.0 - 0.5 * (4.6 + ego_.size.length)) / 8.0, 0.1);
}

TEST_F(PdmScoring, WhoStaysAwayIsNoCollision) {
  const PdmCollision collision =
      scorer({agentAt("lead", {30.0, 0.0, 0.0}, 9.0), agentAt("beside", {0.0, 3.5, 0.0}, 10.0)})
          .collision(straight(10.0));
  EXPECT_EQ(collision.score, 1.0);
  EXPECT_FALSE(collision.time);
}

TEST_F(PdmScoring, AStaticObjectCostsHalf) {
  const Track cone = agentAt("cone", {20.0, 0.0, 0.0}, 0.0, {0.5, 0.5}, AgentClass::kStaticObject);
  EXPECT_EQ(scorer({cone}).collision(straight(10.0)).score, 0.5);
  EXPECT_EQ(scorer({cone, agentAt("lead", {30.0, 0.0, 0.0}, 0.0)}).collision(straight(10.0)).score,
            0.0);
}

TEST_F(PdmScoring, BeingHitFromBehindIsNoFault) {
  EXPECT_EQ(scorer({agentAt("rear", {-20.0, 0.0, 0.0}, 15.0)}).collision(straight(5.0)).score, 1.0);
}

TEST_F(PdmScoring, AStandingEgoIsNeverAtFault) {
  EXPECT_EQ(scorer({agentAt("oncoming", {20.0, 0.0, M_PI}, 10.0)}).collision(straight(0.0)).score,
            1.0);
  EXPECT_EQ(scorer({agentAt("oncoming", {20.0, 0.0, M_PI}, 10.0)}).collision(straight(1.0)).score,
            0.0);
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
  EXPECT_EQ(scorer({agentAt("bus", beside, 0.0, bus)}).collision(motion).score, 0.0);
}

TEST_F(PdmScoring, AHitOnTheSideIsAtFaultOnlyAcrossLanesOrOffRoad) {
  // A car from the right runs into the ego's flank, behind its front, ahead of its rear axle.
  const auto hit_at = [&](double y) {
    const Track crossing = agentAt("crossing", {10.3, y - 10.0, 0.5 * M_PI}, 6.5, {4.0, 1.0});
    return scorer({crossing}).collision(straight(10.0, {0.0, y, 0.0})).score;
  };
  EXPECT_EQ(hit_at(0.0), 1.0);
  EXPECT_EQ(hit_at(1.75), 0.0);   // across two lanes
  EXPECT_EQ(hit_at(-1.75), 0.0);  // half on the verge
}

TEST_F(PdmScoring, WhoWasTouchedWithoutFaultIsLetAlone) {
  // Overtakes through the ego from behind, then brakes in front of it: counted once, no fault.
  PdmMotion motion = straight(5.0);
  for (std::size_t i = 20; i <= 40; ++i) motion.boxes[i].center.x += 0.5 * (i - 20.0);
  EXPECT_EQ(scorer({agentAt("rear", {-8.0, 0.0, 0.0}, 7.5)}).collision(motion).score, 1.0);
}

TEST_F(PdmScoring, LeavingTheDrivableAreaRulesOut) {
  const PdmScorer& scorer = this->scorer({});
  EXPECT_EQ(scorer.drivableArea(straight(10.0)), 1.0);
  EXPECT_EQ(scorer.drivableArea(straight(10.0, {0.0, -0.5, 0.0})), 1.0);
  // 0.115 m over the edge, which is known to half a metre.
  EXPECT_EQ(scorer.drivableArea(straight(10.0, {0.0, -1.0, 0.0})), 1.0);
  EXPECT_EQ(scorer.drivableArea(straight(10.0, {0.0, -1.4, 0.0})), 0.0);
  EXPECT_EQ(scorer.drivableArea(straight(10.0, {0.0, 0.0, -0.1})), 0.0);
}

TEST_F(PdmScoring, AnUnknownDrivableAreaRulesNothingOut) {
  auto bare = std::make_shared<LaneMap>(lanes_->map());
  bare->drivable_area.clear();
  const LaneIndex lanes(bare);
  scorer({});
  const PdmScorer elsewhere({*forecast_, lanes, way_, 0, ego_, bicycle_, {}}, 50.0, pdm().scoring);
  EXPECT_EQ(elsewhere.drivableArea(straight(10.0, {0.0, -40.0, 0.0})), 1.0);
}

TEST_F(PdmScoring, DrivingAgainstTheTrafficCostsByItsDistanceWithinASecond) {
  const PdmScorer& scorer = this->scorer({});
  const Pose2 oncoming{0.0, 7.0, 0.0};
  EXPECT_EQ(scorer.drivingDirection(straight(10.0)), 1.0);
  EXPECT_EQ(scorer.drivingDirection(straight(10.0, {0.0, 3.5, 0.0})), 1.0);
  EXPECT_EQ(scorer.drivingDirection(straight(1.9, oncoming)), 1.0);
  EXPECT_EQ(scorer.drivingDirection(straight(2.1, oncoming)), 0.5);
  EXPECT_EQ(scorer.drivingDirection(straight(5.9, oncoming)), 0.5);
  EXPECT_EQ(scorer.drivingDirection(straight(6.1, oncoming)), 0.0);
  EXPECT_EQ(scorer.drivingDirection(straight(10.0, {0.0, 7.0, M_PI})), 1.0);
}

TEST_F(PdmScoring, TheRoutesOwnLaneIsNeverAgainstTheTraffic) {
  const SampledWay oncoming(Polyline({{-100.0, 7.0}, {200.0, 7.0}}));
  scorer({});
  const PdmScorer elsewhere(
      {*forecast_, *lanes_, oncoming, oncoming.project({0.0, 7.0}).sample, ego_, bicycle_, {}},
      50.0, pdm().scoring);
  EXPECT_EQ(elsewhere.drivingDirection(straight(10.0, {0.0, 7.0, 0.0})), 1.0);
}

TEST_F(PdmScoring, TimeToCollisionLooksAheadOnTheSameSpeed) {
  // At the end of 4 s the gap to the lead is 9.5 - 4 (10 - v) metres; 0.9 s close it at 10 - v m/s.
  const auto at = [&](double lead_speed) {
    const Track lead =
        agentAt("lead", {9.5 + 0.5 * (4.6 + ego_.size.length), 0.0, 0.0}, lead_speed);
    return scorer({lead}).timeToCollision(straight(10.0));
  };
  EXPECT_EQ(at(8.1), 1.0);  // 4.9 * 1.9 = 9.31
  EXPECT_EQ(at(8.0), 0.0);  // 4.9 * 2 = 9.8
  EXPECT_EQ(scorer_->collision(straight(10.0)).score, 1.0);
}

TEST_F(PdmScoring, TimeToCollisionDoesNotMindWhoIsBehindOrBeside) {
  EXPECT_EQ(scorer({agentAt("rear", {-8.0, 0.0, 0.0}, 12.0)}).timeToCollision(straight(8.0)), 1.0);
  const Track closing = agentAt("beside", {0.5, -7.0, 0.5 * M_PI}, 1.0, {4.0, 1.0});
  Track drifting = closing;
  drifting.states.back().velocity = {8.0, 1.0};
  EXPECT_EQ(scorer({drifting}).timeToCollision(straight(8.0)), 1.0);
  // Beside an ego across two lanes it counts.
  drifting.states.back().pose.y += 1.75;
  EXPECT_EQ(scorer({drifting}).timeToCollision(straight(8.0, {0.0, 1.75, 0.0})), 0.0);
}

TEST_F(PdmScoring, AStandingEgoHasTime) {
  const Track lead = agentAt("lead", {4.5, 0.0, 0.0}, -0.2);
  EXPECT_EQ(scorer({lead}).timeToCollision(straight(0.0)), 1.0);
  EXPECT_EQ(scorer({lead}).timeToCollision(straight(0.2)), 0.0);
}

TEST_F(PdmScoring, ComfortIsThatOfTheMotion) {
  const PdmScorer& scorer = this->scorer({});
  PdmMotion motion = straight(10.0);
  EXPECT_EQ(scorer.comfort(motion), 1.0);
  motion.states[20].acceleration = -5.0;
  EXPECT_EQ(scorer.comfort(motion), 0.0);
}

TEST_F(PdmScoring, ProgressIsMeasuredAlongTheWay) {
  const PdmScorer& scorer = this->scorer({});
  EXPECT_NEAR(scorer.progress(straight(10.0)), 40.0, 1e-6);
  EXPECT_NEAR(scorer.progress(straight(10.0, {0.0, 0.0, 0.5})), 40.0 * std::cos(0.5), 1e-6);
  EXPECT_EQ(scorer.progress(straight(10.0, {0.0, 0.0, M_PI})), 0.0);
}

TEST_F(PdmScoring, TheTotalIsTheProductTimesTheWeightedMean) {
  // The faster one hits the cone: half its way counts, half its total.
  const Track cone = agentAt("cone", {39.0, 0.0, 0.0}, 0.0, {0.5, 0.5}, AgentClass::kStaticObject);
  const std::vector<PdmScore> scores = scorer({cone}).score({straight(5.0), straight(10.0)});
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
      scorer({lead}).score({straight(3.0), straight(5.0), straight(15.0)});
  EXPECT_NEAR(scores[0].progress, 0.6, 1e-6);
  EXPECT_NEAR(scores[1].progress, 1.0, 1e-6);
  EXPECT_EQ(scores[2].total, 0.0);
}

TEST_F(PdmScoring, WhereNobodyGetsOnProgressIsTheSame) {
  const std::vector<PdmScore> scores = scorer({}).score({straight(0.0), straight(0.02)});
  EXPECT_EQ(scores[0].progress, 1.0);
  EXPECT_EQ(scores[1].progress, 1.0);
}

}  // namespace
}  // namespace forge
