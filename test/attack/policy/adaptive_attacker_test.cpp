#include "collision_forge/attack/policy/adaptive_attacker.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <string>

#include "attack/policy/policy_scenes.h"
#include "collision_forge/attack/search/judge.h"
#include "collision_forge/attack/verify/drive_check.h"
#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

double steady(double /*seconds*/) { return 8.0; }
double braking(double seconds) { return std::max(3.0, 8.0 - 2.5 * seconds); }

const AttackerPlan& lastPlan(const AttackerPolicy& policy) { return policy.plans().back(); }

TEST(AdaptiveAttacker, HitsABrakingEgoThatAFixedAttackerMisses) {
  const Chase chase;
  const Track ego = egoAt(braking);
  FixedAttacker fixed(chase.firstAttack().trajectory);
  EXPECT_FALSE(reportOf(fixed, ego, chase).on_time);
  AdaptiveAttacker attacker = chase.attacker();
  watch(attacker, ego, 5.5);
  const CollisionReport report = reportOf(attacker, ego, chase);
  EXPECT_TRUE(report.verified()) << report.broken_limit << " " << lastPlan(attacker).reason;
  EXPECT_EQ(report.unbelievable, "");
  EXPECT_GT(attacker.plans().size(), 1u);
}

TEST(AdaptiveAttacker, KeepsTheConstraintsOfTheRequest) {
  Chase chase;
  chase.request.manoeuvre = Manoeuvre::kFollowerCloses;
  chase.request.ego_side = Side::kRear;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(braking);
  watch(attacker, ego, 5.5);
  EXPECT_EQ(shortcomingOf(reportOf(attacker, ego, chase), chase.request), "");
  EXPECT_GT(attacker.plans().size(), 1u);
}

TEST(AdaptiveAttacker, KeepsAPlanThatStillHitsTheEgo) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(steady);
  watch(attacker, ego, 3.8);
  EXPECT_TRUE(reportOf(attacker, ego, chase).verified());
  EXPECT_LE(attacker.plans().size(), 3u) << "hardly anything is changed";
}

TEST(AdaptiveAttacker, KeepsItsPlanDuringTheReactionTime) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(braking);
  int changes = 0;
  for (int i = 1; i <= 45; ++i) {
    const std::vector<TrajectoryPoint> before = attacker.trajectory().points;
    const double time = kNow + 0.1 * i;
    attacker.observe(frameOf(ego, time));
    const std::vector<TrajectoryPoint>& after = attacker.trajectory().points;
    ASSERT_EQ(after.size(), before.size());
    for (std::size_t j = 0; j < after.size(); ++j) {
      const bool is_same = after[j].pose.x == before[j].pose.x &&
                           after[j].pose.y == before[j].pose.y && after[j].speed == before[j].speed;
      changes += !is_same;
      if (after[j].time > time + shippedAdaptive().fairness.reaction_time - 1e-6) continue;
      ASSERT_TRUE(is_same) << i << " " << j;
    }
  }
  EXPECT_GT(changes, 0);
}

TEST(AdaptiveAttacker, IgnoresTheRecordedFuture) {
  const Chase chase;
  AdaptiveAttacker one = chase.attacker();
  AdaptiveAttacker other = chase.attacker();
  const auto parting = [](double seconds) { return seconds < 2.0 ? 8.0 : 12.0; };
  watch(one, egoAt(steady), 5.5);
  watch(other, egoAt(parting), 5.5);
  bool parted = false;
  for (std::size_t i = 0; i < one.trajectory().points.size(); ++i) {
    const TrajectoryPoint& a = one.trajectory().points[i];
    const TrajectoryPoint& b = other.trajectory().points[i];
    if (a.time <= kNow + 2.0 + shippedAdaptive().fairness.reaction_time) {
      ASSERT_EQ(a.pose.x, b.pose.x) << a.time;
    }
    parted = parted || a.pose.x != b.pose.x;
  }
  EXPECT_TRUE(parted);
}

TEST(AdaptiveAttacker, WholeDriveKeepsTheLimitsForRandomEgoMotion) {
  const unsigned seed = 20261123;
  SCOPED_TRACE("seed " + std::to_string(seed));
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> change(-4.0, 3.0);
  const Chase chase;
  const DriveLimits limits = driveLimitsOf(chase.snapshot.agents[0], shippedOptions().verification);
  const DriveState start = driveStateNow(chase.snapshot.agents[0], shippedOptions().verification);
  for (int run = 0; run < 12; ++run) {
    const double first = change(generator);
    const double then = change(generator);
    const Track ego = egoAt([&](double t) {
      return std::max(0.0, 8.0 + first * std::min(t, 2.0) + then * std::max(0.0, t - 2.0));
    });
    AdaptiveAttacker attacker = chase.attacker();
    watch(attacker, ego, 5.8);
    const auto broken = findBrokenDrive(attacker.trajectory().points, start,
                                        std::numeric_limits<double>::infinity(), limits);
    EXPECT_FALSE(broken) << describe(*broken) << " " << first << " " << then;
  }
}

TEST(AdaptiveAttacker, AggressivenessScalesTheLimitsOfNewPlans) {
  const double share = 0.5;
  const Chase chase;
  const Realization first = chase.firstAttack();
  AttackerSetup setup = shippedSetupOfAttackers();
  setup.adaptive.fairness.aggressiveness = share;
  AdaptiveAttacker attacker(
      {chase.snapshot, chase.lanes, chase.ego, chase.request, first.aim, first.trajectory}, setup);
  watch(attacker, egoAt(braking), 3.5);
  const DriveLimits limits = driveLimitsOf(chase.snapshot.agents[0], shippedOptions().verification);
  int planned = 0;
  for (std::size_t i = 1; i < attacker.plans().size(); ++i) {
    const AttackerPlan& plan = attacker.plans()[i];
    if (plan.phase != AttackerPhase::kAttacking) continue;
    ++planned;
    for (const TrajectoryPoint& point : plan.points) {
      if (point.time < plan.from + 1.0) continue;  // it comes from harder braking
      EXPECT_GT(point.acceleration, -share * limits.max_braking - 1e-6) << point.time;
      EXPECT_LT(point.acceleration, share * limits.max_forward_acceleration + 1e-6) << point.time;
    }
  }
  EXPECT_GT(planned, 0);
}

TEST(AdaptiveAttacker, AbortsWhenTheEgoJumps) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(steady);
  watch(attacker, ego, 1.0);
  Frame jumped = frameOf(ego, kNow + 1.1);
  jumped.ego.x += 80.0;
  attacker.observe(jumped);
  EXPECT_EQ(attacker.phase(), AttackerPhase::kDrivingOn);
  EXPECT_EQ(lastPlan(attacker).reason, "the ego jumped");
}

TEST(AdaptiveAttacker, AbortsWithoutContactWhenTheEgoIsFarAway) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  // It leaves at four times the speed.
  const Track ego = egoAt([](double t) { return std::min(32.0, 8.0 + 12.0 * t); });
  watch(attacker, ego, 5.8);
  EXPECT_EQ(attacker.phase(), AttackerPhase::kDrivingOn);
  EXPECT_FALSE(reportOf(attacker, ego, chase).contact);
}

TEST(AdaptiveAttacker, ObservesOtherAgentsWhileTheEgoIsLost) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  watch(attacker, egoAt(steady), 0.5);
  const double nowhere = std::numeric_limits<double>::quiet_NaN();
  Track wall = pastTrack("wall", {4.6, 4.0}, {28.0, 0.0, 0.0}, 0.0);
  for (int i = 6; i <= 58; ++i) {
    const double time = kNow + 0.1 * i;
    wall.states = {{time, {28.0, 0.0, 0.0}, {0.0, 0.0}}};
    attacker.observe({time, {nowhere, nowhere, nowhere}, {wall}});
  }
  EXPECT_EQ(lastPlan(attacker).reason, "the ego is no longer observed");
  EXPECT_LT(attacker.trajectory().points.back().pose.x + 0.5 * kCarSize.length, 28.0 - 2.3);
}

TEST(AdaptiveAttacker, NewPlansKeepTheClassLimitsWhateverTheRequestSays) {
  Chase chase;
  chase.request.mode = Mode::kHistory;
  chase.request.crash.believable = false;
  const Realization first = chase.firstAttack();
  ASSERT_EQ(first.status.code, StatusCode::kOk) << first.status.message;
  chase.request.crash.limits = LimitSet::kStrict;
  AdaptiveAttacker attacker(
      {chase.snapshot, chase.lanes, chase.ego, chase.request, first.aim, first.trajectory},
      shippedSetupOfAttackers());
  const Track ego = egoAt(braking);
  watch(attacker, ego, 5.5);
  EXPECT_GT(attacker.plans().size(), 1u);
}

TEST(AdaptiveAttacker, ExtendsAShortTrajectoryStraight) {
  const Chase chase;
  Realization first = chase.firstAttack();
  const std::size_t all = first.trajectory.points.size();
  first.trajectory.points.resize(12);
  first.trajectory.points.erase(first.trajectory.points.begin() + 5);
  AdaptiveAttacker attacker(
      {chase.snapshot, chase.lanes, chase.ego, chase.request, first.aim, first.trajectory},
      shippedSetupOfAttackers());
  ASSERT_EQ(attacker.trajectory().points.size(), all);
  for (std::size_t i = 1; i < all; ++i) {
    EXPECT_NEAR(attacker.trajectory().points[i].time, kNow + 0.1 * static_cast<double>(i), 1e-6);
  }
  watch(attacker, egoAt(steady), 5.8);
  EXPECT_EQ(attacker.trajectory().points.size(), all);
}

TEST(AdaptiveAttacker, IgnoresLateAndTooFrequentFrames) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  AdaptiveAttacker plain = chase.attacker();
  const Track ego = egoAt(braking);
  for (int i = 1; i <= 50; ++i) {
    const double time = kNow + 0.1 * i;
    plain.observe(frameOf(ego, time));
    attacker.observe(frameOf(ego, time));
    attacker.observe(frameOf(egoAt(steady), time + 0.03));
    attacker.observe(frameOf(egoAt(steady), time - 0.4 + 0.4 * (i < 5)));
  }
  ASSERT_EQ(plain.trajectory().points.size(), attacker.trajectory().points.size());
  for (std::size_t i = 0; i < plain.trajectory().points.size(); ++i) {
    EXPECT_EQ(plain.trajectory().points[i].pose.x, attacker.trajectory().points[i].pose.x);
  }
}

TEST(AdaptiveAttacker, AbortsWhenAnotherAgentBlocksThePlan) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(steady);
  Track wall = pastTrack("wall", {4.6, 4.0}, {6.0, 0.0, 0.0}, 0.0);
  wall.states = {{0.0, {6.0, 0.0, 0.0}, {0.0, 0.0}}};
  for (int i = 6; i <= 50; ++i) {
    Frame frame = frameOf(ego, kNow + 0.1 * i);
    wall.states.front().time = frame.time;
    frame.agents = {wall};
    attacker.observe(frame);
  }
  EXPECT_EQ(attacker.phase(), AttackerPhase::kDrivingOn);
  EXPECT_LT(attacker.trajectory().points.back().pose.x + 0.5 * kCarSize.length, 6.0 - 2.3)
      << "it stops before the wall";
}

TEST(AdaptiveAttacker, CommitsWhenItIsTooLateToReplan) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(steady);
  watch(attacker, ego, 3.8);
  EXPECT_EQ(attacker.phase(), AttackerPhase::kAttacking);
  watch(attacker, ego, 4.2);
  EXPECT_EQ(attacker.phase(), AttackerPhase::kCommitted);
  watch(attacker, ego, 5.0);
  EXPECT_EQ(attacker.phase(), AttackerPhase::kDrivingOn);
}

TEST(AdaptiveAttacker, OutlookIsTheObservedPastThenAForecast) {
  const Chase chase;
  AdaptiveAttacker attacker = chase.attacker();
  const Track ego = egoAt(braking);
  watch(attacker, ego, 3.0);
  const std::vector<AgentState> states = attacker.outlook().ego.states;
  ASSERT_GT(states.size(), 31u);
  for (std::size_t i = 0; i <= 30; ++i) {
    EXPECT_NEAR(states[i].time, kNow + 0.1 * static_cast<double>(i), 1e-9);
    EXPECT_NEAR(states[i].pose.x, ego.states[i].pose.x, 1e-6);
  }
  for (std::size_t i = 1; i < states.size(); ++i) EXPECT_GT(states[i].time, states[i - 1].time);
  EXPECT_NEAR(states.back().time, attacker.trajectory().points.back().time, 0.2);
  const double forecast = states.back().pose.x - states[30].pose.x;
  EXPECT_LT(forecast, 8.0 * (states.back().time - states[30].time)) << "it has braked";
}

}  // namespace
}  // namespace forge
