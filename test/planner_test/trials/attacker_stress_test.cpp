#include "collision_forge/planner_test/trials/attacker_stress.h"

#include <gtest/gtest.h>

#include "planner_test/trials/rear_end_case.h"

namespace forge {
namespace {

/// A policy that records the observed ego.
class EgoRecorder : public FixedAttacker {
 public:
  explicit EgoRecorder(const AttackerTrajectory& trajectory) : FixedAttacker(trajectory) {}
  std::unique_ptr<AttackerPolicy> clone() const override {
    return std::make_unique<EgoRecorder>(*this);
  }
  void observe(const Frame& seen) override { seen_->push_back(seen.ego); }
  const std::vector<Pose2>& seen() const { return *seen_; }

 private:
  std::shared_ptr<std::vector<Pose2>> seen_ = std::make_shared<std::vector<Pose2>>();
};

class AttackerStressTest : public testing::Test {
 protected:
  StressOutcome stress(EgoConduct conduct, const AttackerPolicy& attacker, std::uint64_t seed = 3) {
    return stressAttacker(one_.scenario, one_.request, conduct, seed,
                          {config().planners, config().attack, config().crash.types,
                           Background::kReplay, false, &attacker});
  }

  std::vector<Pose2> observedWith(EgoConduct conduct, std::uint64_t seed = 3) {
    const EgoRecorder recorder(one_.scenario.attacker);
    stress(conduct, recorder, seed);
    return recorder.seen();
  }

  PlannerCase one_ = rearEnd();
};

TEST_F(AttackerStressTest, EveryConductMovesTheEgoAsNamed) {
  const auto stops = observedWith(EgoConduct::kStops);
  EXPECT_EQ(stops[stops.size() - 2].x, stops.back().x);
  const auto reverses = observedWith(EgoConduct::kReverses);
  EXPECT_LT(reverses.back().x, reverses[reverses.size() - 2].x);
  const auto vanishes = observedWith(EgoConduct::kVanishes);
  EXPECT_TRUE(vanishes.front().isFinite());
  EXPECT_FALSE(vanishes.back().isFinite());
  const auto jumps = observedWith(EgoConduct::kJumps);
  double longest = 0.0;
  for (std::size_t i = 1; i < jumps.size(); ++i) {
    longest = std::max(longest, jumps[i].x - jumps[i - 1].x);
  }
  EXPECT_GT(longest, 25.0);
  const auto evades = observedWith(EgoConduct::kEvades);
  EXPECT_EQ(evades.front().x, jumps.front().x) << "all start as recorded";
}

TEST_F(AttackerStressTest, ReportsAViolatedLimitAndATouchedAgent) {
  one_.request.crash.limits = LimitSet::kDrivable;
  AttackerTrajectory odd = one_.scenario.attacker;
  EXPECT_EQ(stress(EgoConduct::kVanishes, FixedAttacker(odd)).broken_limit, "");
  odd.points[3].pose.y += 1.0;
  EXPECT_NE(stress(EgoConduct::kVanishes, FixedAttacker(odd)).broken_limit, "");
  one_.scenario.recorded.agents.push_back(
      {"wall", AgentClass::kCar, {2.0, 2.0}, one_.scenario.recorded.ego.states});
  EXPECT_EQ(stress(EgoConduct::kVanishes, FixedAttacker(one_.scenario.attacker)).touched, "wall");
}

TEST_F(AttackerStressTest, LimitsAreCheckedAfterContactToo) {
  one_.request.crash.limits = LimitSet::kDrivable;
  AttackerTrajectory odd = one_.scenario.attacker;
  EXPECT_TRUE(stress(EgoConduct::kStops, FixedAttacker(odd)).touches_ego);
  EXPECT_EQ(stress(EgoConduct::kStops, FixedAttacker(odd)).broken_limit, "");
  odd.points[odd.points.size() - 2].pose.y += 1.0;
  EXPECT_TRUE(stress(EgoConduct::kStops, FixedAttacker(odd)).touches_ego);
  EXPECT_NE(stress(EgoConduct::kStops, FixedAttacker(odd)).broken_limit, "");
}

TEST_F(AttackerStressTest, AnAdaptiveAttackerKeepsItsLimitsAndAbortsWhenTheEgoJumps) {
  one_.request.crash.limits = LimitSet::kDrivable;
  const auto attacker = makeAttacker(one_, PolicyKind::kAdaptive, {}, config());
  for (const EgoConduct conduct : kEgoConducts) {
    for (std::uint64_t seed = 0; seed < 4; ++seed) {
      const StressOutcome outcome = stress(conduct, *attacker, seed);
      EXPECT_EQ(outcome.broken_limit, "") << toString(conduct) << ", seed " << seed;
    }
  }
  EXPECT_EQ(stress(EgoConduct::kJumps, *attacker, 0).phase, AttackerPhase::kDrivingOn);
}

}  // namespace
}  // namespace forge
