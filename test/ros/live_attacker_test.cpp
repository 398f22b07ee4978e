#include "collision_forge/ros/injection/live_attacker.h"

#include <gtest/gtest.h>

#include "attack/policy/policy_scenes.h"
#include "collision_forge/ros/messages/conversions.h"

namespace forge {
namespace {

constexpr double kClock = 5000.0;  // s; that of the node goes its own way

double steady(double /*seconds*/) { return 8.0; }
double braking(double seconds) { return std::max(3.0, 8.0 - 2.5 * seconds); }

class LiveAttackerTest : public testing::Test {
 protected:
  explicit LiveAttackerTest(bool keeps_attack = true)
      : live_([this](const auto& attack) { published_.push_back(attack); }, keeps_attack, 40.0) {}

  collision_forge::Attack start() {
    const Attack first = chase_.firstAttack();
    return live_.start(toMessage(first, "search", kNow),
                       {chase_.snapshot, chase_.lanes, chase_.ego, chase_.request, first.pattern,
                        first.trajectory},
                       shippedSetupOfAttackers());
  }

  /// Frames after `from` seconds from kNow up to `until`; before kNow the ego stands.
  void addFrames(const SpeedOf& speed, double from, double until) {
    const Track ego = egoAt(speed);
    for (int i = static_cast<int>(std::lround(10.0 * from)) + 1; 0.1 * i <= until + 1e-9; ++i) {
      Frame frame = frameOf(ego, kNow + 0.1 * std::max(i, 0));
      frame.time = kNow + 0.1 * i;
      live_.addFrame(frame, kClock + 0.1 * i);
    }
  }

  /// One from before kNow.
  void seeTheStart() { live_.addFrame({kNow - 1.0, {-8.0, 0.0, 0.0}, {}}, kClock + 9.0); }

  collision_forge::AttackerTrajectory drivenBy(const SpeedOf& speed, double until) const {
    AdaptiveAttacker attacker = chase_.attacker();
    watch(attacker, egoAt(speed), until);
    return toMessage(attacker.trajectory());
  }

  Chase chase_;
  std::vector<collision_forge::Attack> published_;
  LiveAttacker live_;
};

class ForgetfulLiveAttackerTest : public LiveAttackerTest {
 protected:
  ForgetfulLiveAttackerTest() : LiveAttackerTest(false) {}
};

TEST_F(ForgetfulLiveAttackerTest, ARestartedReplayDropsTheAttack) {
  start();
  addFrames(braking, 0.0, 3.0);
  seeTheStart();
  EXPECT_EQ(published_.back(), collision_forge::Attack());
  const std::size_t before = published_.size();
  addFrames(braking, -0.5, 5.5);
  EXPECT_EQ(published_.size(), before);
}

TEST_F(LiveAttackerTest, IsRemovedOnceOnRequest) {
  start();
  EXPECT_TRUE(live_.end());
  EXPECT_EQ(published_.back(), collision_forge::Attack());
  EXPECT_FALSE(live_.end());
  const std::size_t before = published_.size();
  addFrames(braking, 0.0, 3.0);
  EXPECT_EQ(published_.size(), before);
}

TEST_F(LiveAttackerTest, StartsWithThePublishedAttack) {
  const collision_forge::Attack first = start();
  ASSERT_EQ(published_.size(), 1u);
  EXPECT_EQ(published_[0], first);
  EXPECT_EQ(first.trajectory, toMessage(chase_.firstAttack().trajectory));
  EXPECT_TRUE(first.adaptive);
  EXPECT_EQ(first.phase, "attacking");
  EXPECT_EQ(first.decision, "initial plan");
  EXPECT_EQ(first.decided, stampOf(kNow));
  EXPECT_EQ(first.plans, 1u);
}

TEST_F(LiveAttackerTest, PublishesEveryDecisionWithTheNewPrediction) {
  start();
  addFrames(braking, 0.0, 5.5);
  ASSERT_GT(published_.size(), 2u);
  for (std::size_t i = 1; i < published_.size(); ++i) {
    const collision_forge::Attack& attack = published_[i];
    EXPECT_EQ(attack.header, published_[0].header);
    EXPECT_EQ(attack.pattern, published_[0].pattern);
    EXPECT_EQ(attack.report.confidence, published_[0].report.confidence);
    EXPECT_EQ(attack.report.decision, attack.decision);
    EXPECT_GE(attack.plans, published_[i - 1].plans);
  }
  const collision_forge::Attack& last = published_.back();
  EXPECT_EQ(last.trajectory, drivenBy(braking, 5.5));
  EXPECT_EQ(last.phase, "driving_on");
  EXPECT_EQ(last.decision, "the requested time has passed");
  const CollisionReport report =
      reportOf(FixedAttacker(fromMessage(last.trajectory)), egoAt(braking), chase_);
  EXPECT_TRUE(last.report.verified);
  EXPECT_NEAR(last.report.contact_time.toSec(), report.contact_time, 0.01);
  EXPECT_NEAR(last.report.impact_speed, report.impact_speed, 0.3);
  EXPECT_NE(last.report.contact_time, published_[0].report.contact_time);
}

TEST_F(LiveAttackerTest, ReplaysTheFramesReceivedDuringTheRequest) {
  addFrames(braking, -0.5, 1.5);
  const collision_forge::Attack first = start();
  EXPECT_EQ(published_.front(), first);
  EXPECT_EQ(published_.back().trajectory, drivenBy(braking, 1.5));
  EXPECT_GT(published_.back().plans, 1u);
  addFrames(braking, 1.5, 5.5);
  EXPECT_EQ(published_.back().trajectory, drivenBy(braking, 5.5));
}

TEST_F(LiveAttackerTest, StartsAgainWithARestartedReplay) {
  const collision_forge::Attack first = start();
  addFrames(braking, 0.0, 3.0);
  ASSERT_GT(published_.back().plans, 1u);
  seeTheStart();
  EXPECT_EQ(published_.back(), first);
  const std::size_t before = published_.size();
  addFrames(steady, -0.5, 0.0);
  EXPECT_EQ(published_.size(), before);
  addFrames(braking, 0.0, 5.5);
  EXPECT_EQ(published_.back().trajectory, drivenBy(braking, 5.5));
}

TEST_F(LiveAttackerTest, AbortsIfNoFrameArrives) {
  start();
  addFrames(braking, 0.0, 1.0);
  const std::size_t before = published_.size();
  live_.checkForLostFrames(kClock + 1.5);
  live_.checkForLostFrames(kClock + 2.0);
  EXPECT_EQ(published_.size(), before) << "for a moment nothing is given up";
  live_.checkForLostFrames(kClock + 2.5);
  ASSERT_EQ(published_.size(), before + 1);
  EXPECT_EQ(published_.back().phase, "driving_on");
  EXPECT_EQ(published_.back().decision, "the ego is no longer observed");
  EXPECT_NEAR(published_.back().decided.toSec(),
              kNow + 2.5 + shippedAdaptive().fairness.reaction_time, 0.1);
  live_.checkForLostFrames(kClock + 3.0);
  EXPECT_EQ(published_.size(), before + 1);
}

TEST_F(LiveAttackerTest, AFastClockAloneDoesNotAbortTheAttack) {
  start();
  addFrames(braking, 0.0, 1.0);
  const std::size_t before = published_.size();
  live_.checkForLostFrames(kClock + 9.0);
  addFrames(braking, 1.0, 1.1);
  live_.checkForLostFrames(kClock + 9.0);
  for (std::size_t i = before; i < published_.size(); ++i) {
    EXPECT_EQ(published_[i].phase, "attacking");
  }
}

TEST_F(LiveAttackerTest, AFixedAttackReplacesAnAdaptiveOne) {
  start();
  addFrames(braking, 0.0, 0.5);
  collision_forge::Attack fixed;
  fixed.method = "fixed";
  live_.start(fixed);
  EXPECT_EQ(published_.back(), fixed);
  const std::size_t before = published_.size();
  addFrames(braking, 0.5, 3.0);
  seeTheStart();
  live_.checkForLostFrames(kClock + 20.0);
  live_.checkForLostFrames(kClock + 30.0);
  EXPECT_EQ(published_.size(), before);
}

}  // namespace
}  // namespace forge
