#include "collision_forge/planner_test/trials/evasion.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rear_end_case.h"
#include "planner_test/trials/rollout_scenes.h"

namespace forge {
namespace {

/// A policy that drives given points regardless of its observations.
class Reader : public Planner {
 public:
  explicit Reader(std::vector<TrajectoryPoint> points) : points_(std::move(points)) {}

  void initialize(const DrivingTask& /*task*/) override {}

  std::vector<TrajectoryPoint> plan(const Observation& observation) override {
    std::vector<TrajectoryPoint> rest = {observation.ego};
    for (const TrajectoryPoint& point : points_) {
      if (point.time > observation.ego.time + 1e-3) rest.push_back(point);
    }
    return rest;
  }

 private:
  std::vector<TrajectoryPoint> points_;
};

constexpr Driving kExact{0.1, true};

/// A policy that moves to the ego's last observed pose.
class Clinger : public FixedAttacker {
 public:
  using FixedAttacker::FixedAttacker;
  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<Clinger>(*this);
  }
  void observe(const Frame& seen) override {
    moved_ = FixedAttacker::trajectory();
    for (TrajectoryPoint& point : moved_.points) {
      if (point.time > seen.time) point.pose = seen.ego;
    }
  }
  const AttackerTrajectory& trajectory() const override { return moved_; }

 private:
  AttackerTrajectory moved_ = FixedAttacker::trajectory();
};

std::vector<TrajectoryPoint> straightOn(const CrashScenario& scenario, double speed) {
  std::vector<TrajectoryPoint> points;
  for (double time = 0.0; kNow + time < scenario.end() + 0.05; time += 0.1) {
    points.push_back({kNow + time, {speed * time, 0.0, 0.0}, speed, 0.0, 0.0});
  }
  return points;
}

TEST(Evasion, AWitnessAvoidsTheAttackerInClosedLoop) {
  PlannerCase one = rearEnd();
  one.request.crash.limits = LimitSet::kDrivable;
  const auto attacker = makeAttacker(one, PolicyKind::kAdaptive, {}, config());
  RolloutSetup setup{config().planners, config().attack, config().crash, Background::kReplay, true,
                     attacker.get()};
  const PlannerUnderTest idm = makePlanner("idm", config().planners, "");
  const RolloutOutcome hit = rollout(*idm.planner, idm.driving, one.scenario, setup);
  ASSERT_TRUE(hit.contact && hit.contact->is_attacker);
  const auto evasion = findEvasion(one.scenario, hit.driven, setup);
  ASSERT_TRUE(evasion);
  EXPECT_LT(evasion->ego.start, hit.contact->time);
  EXPECT_GT(evasion->ego.start, hit.contact->time - 2.0) << "a follower can be avoided late";

  Reader reader(wholeEvasion(hit.driven, evasion->ego));
  const RolloutOutcome evaded = rollout(reader, kExact, one.scenario, setup);
  EXPECT_EQ(evaded.failure, PlannerFailure::kNone) << evaded.failure_message;
  EXPECT_FALSE(evaded.contact);
  const auto& reaction = evasion->attacker.points;
  ASSERT_EQ(reaction.size(), evaded.attacker.points.size());
  for (std::size_t i = 0; i < reaction.size(); ++i) {
    EXPECT_NEAR(reaction[i].pose.x, evaded.attacker.points[i].pose.x, 1e-6);
  }
}

TEST(MakeAttacker, AVehicleThatReversesKeepsToItsPlan) {
  PlannerCase one = rearEnd();
  EXPECT_TRUE(makeAttacker(one, PolicyKind::kAdaptive, {}, config()));
  one.request.type = CollisionType::kJunctionCrossing;
  one.request.manoeuvre = Manoeuvre::kBackOut;
  EXPECT_FALSE(makeAttacker(one, PolicyKind::kAdaptive, {}, config()));
}

TEST(Evasion, AnAttackerAlwaysAtTheEgoIsUnavoidable) {
  const CrashScenario scenario = roadScenario(10.0, straightDrive({15.0, 0.0, 0.0}, 0.0, 3.0));
  const Clinger attacker(scenario.attacker);
  RolloutSetup setup = shippedSetup();
  setup.attacker = &attacker;
  Reader reader(straightOn(scenario, 10.0));
  const RolloutOutcome hit = rollout(reader, kExact, scenario, setup);
  ASSERT_TRUE(hit.contact);
  EXPECT_FALSE(findEvasion(scenario, hit.driven, setup));
}

TEST(Evasion, MatchesFindAvoidabilityForAFixedAttacker) {
  // Contact comes at (40 - 4.342) / 10 = 3.57 s.
  const CrashScenario scenario = roadScenario(10.0, straightDrive({40.0, 0.0, 0.0}, 0.0, 7.0));
  const FixedAttacker attacker(scenario.attacker);
  RolloutSetup setup = shippedSetup();
  setup.attacker = &attacker;
  Reader reader(straightOn(scenario, 10.0));
  const RolloutOutcome hit = rollout(reader, kExact, scenario, setup);
  ASSERT_TRUE(hit.contact);
  const auto evasion = findEvasion(scenario, hit.driven, setup);
  const Avoidability known = findAvoidability(scenario, setup.planners.avoidability,
                                              setup.planners.planning.route, setup.attack);
  ASSERT_TRUE(evasion && known.last);
  EXPECT_NEAR(evasion->ego.start, known.last->start, 1e-6);
}

}  // namespace
}  // namespace forge
