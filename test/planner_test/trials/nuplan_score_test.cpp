#include "collision_forge/planner_test/trials/nuplan_score.h"

#include <gtest/gtest.h>

#include <functional>

#include "planner_test/planners/planner_scenes.h"

namespace forge {
namespace {

/// The ego on a lane 4 m wide along x; a parallel lane is not on the route.
class NuplanScoring : public testing::Test {
 protected:
  static PdmArea lane(double y, bool is_on_route) {
    return {{{-200.0, y - 2.0}, {400.0, y - 2.0}, {400.0, y + 2.0}, {-200.0, y + 2.0}},
            is_on_route,
            {}};
  }

  NuplanJudge judge() const {
    const PlannerOptions& planners = shippedConfig().planners;
    return {map_, shippedConfig().ego_vehicle, planners.pdm.scoring,
            shippedConfig().planners.nuplan_score};
  }

  /// After 4 s of driving as told, progress as asked for.
  NuplanScore driven(const std::function<TrajectoryPoint(double)>& at,
                     const std::vector<Track>& agents = {}, double share = 1.0) const {
    NuplanJudge judge = this->judge();
    for (int i = 0; i <= 40; ++i) judge.addStep(at(0.1 * i), agents, {"ignored"});
    return judge.score({}, 40.0 * share, 40.0);
  }

  static std::function<TrajectoryPoint(double)> straight(double speed, double y = 0.0) {
    return [=](double time) -> TrajectoryPoint {
      return {time, {speed * time, y, 0.0}, speed, 0.0, 0.0};
    };
  }

  const PdmMap map_{{lane(0.0, true), lane(4.0, false)}, {}};
};

TEST_F(NuplanScoring, CalmDrivingIsPerfect) {
  const NuplanScore score = driven(straight(10.0));
  for (const NuplanPart& part : nuplanParts()) EXPECT_EQ(score.*part.value, 1.0) << part.name;
  EXPECT_FALSE(score.speed_limit);
}

TEST_F(NuplanScoring, OnlyAtFaultContactsReduceTheScore) {
  const NuplanJudge judge = this->judge();
  EXPECT_EQ(judge.score(NuplanContact{false, false}, 1.0, 1.0).no_at_fault_collision, 1.0);
  EXPECT_EQ(judge.score(NuplanContact{true, true}, 1.0, 1.0).no_at_fault_collision, 0.5);
  EXPECT_EQ(judge.score(NuplanContact{true, false}, 1.0, 1.0).total, 0.0);
}

TEST_F(NuplanScoring, LeavingTheRoadScoresZero) {
  EXPECT_EQ(driven(straight(10.0, -1.0)).drivable_area, 1.0);
  EXPECT_EQ(driven(straight(10.0, -1.5)).total, 0.0);
}

TEST_F(NuplanScoring, WrongWayDistanceIsSummedOverASecond) {
  EXPECT_EQ(driven(straight(1.9, 4.0)).driving_direction, 1.0);
  EXPECT_EQ(driven(straight(2.1, 4.0)).driving_direction, 0.5);
  EXPECT_EQ(driven(straight(6.1, 4.0)).driving_direction, 0.0);
}

TEST_F(NuplanScoring, LittleProgressCountsAsNone) {
  EXPECT_NEAR(driven(straight(10.0), {}, 0.5).progress, 0.5, 1e-12);
  EXPECT_EQ(driven(straight(10.0), {}, 0.21).making_progress, 1.0);
  EXPECT_EQ(driven(straight(10.0), {}, 0.19).total, 0.0);
  EXPECT_EQ(driven(straight(10.0), {}, 1.5).progress, 1.0);
  // Progress below 2 m counts as 2 m; far backwards counts as none.
  EXPECT_EQ(judge().score({}, 0.0, 0.5).progress, 1.0);
  EXPECT_EQ(judge().score({}, -3.0, 0.5).progress, 0.0);
}

TEST_F(NuplanScoring, AnAgentBesideCountsOnlyInSeveralLanes) {
  // An agent comes from the right, towards the ego's rear half.
  const std::vector<Track> crossing = {agentAt("a", {-1.0, -3.0, 0.5 * M_PI}, 2.0, {2.0, 1.0})};
  const auto standing_at = [](double y) {
    return [=](double time) -> TrajectoryPoint { return {time, {0.0, y, 0.0}, 0.1, 0.0, 0.0}; };
  };
  EXPECT_EQ(driven(standing_at(0.0), crossing).time_to_collision, 1.0);
  const std::vector<Track> other = {agentAt("a", {-1.0, -1.0, 0.5 * M_PI}, 2.0, {2.0, 1.0})};
  EXPECT_EQ(driven(standing_at(2.0), other).time_to_collision, 0.0);
}

TEST_F(NuplanScoring, HardBrakingIsUncomfortable) {
  const auto braking = [](double rate) {
    return [=](double time) -> TrajectoryPoint {
      return {
          time, {20.0 * time - 0.5 * rate * time * time, 0.0, 0.0}, 20.0 - rate * time, -rate, 0.0};
    };
  };
  EXPECT_EQ(driven(braking(4.0)).comfort, 1.0);
  EXPECT_EQ(driven(braking(4.2)).comfort, 0.0);
  EXPECT_NEAR(driven(braking(4.2)).total, 10.0 / 12.0, 1e-12);
}

TEST_F(NuplanScoring, SpeedLimitsCountWhereTheyAreKnown) {
  PdmArea limited = lane(0.0, true);
  limited.speed_limit = 9.0;
  const PdmMap map({limited}, {});
  const PlannerOptions& planners = shippedConfig().planners;
  const NuplanScoreOptions& options = shippedConfig().planners.nuplan_score;
  const auto scored = [&](double speed) {
    NuplanJudge judge(map, shippedConfig().ego_vehicle, planners.pdm.scoring, options);
    for (int i = 0; i <= 40; ++i) judge.addStep(straight(speed)(0.1 * i), {}, {});
    return judge.score({}, 1.0, 1.0);
  };
  EXPECT_EQ(scored(9.0).speed_limit, 1.0);
  EXPECT_NEAR(*scored(10.0).speed_limit, 1.0 - 1.0 / options.max_overspeed, 1e-12);
  EXPECT_EQ(scored(12.0).speed_limit, 0.0);
  EXPECT_NEAR(scored(12.0).total, 12.0 / 16.0, 1e-12);
}

}  // namespace
}  // namespace forge
