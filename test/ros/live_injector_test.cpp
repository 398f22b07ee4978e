#include "collision_forge/ros/injection/live_injector.h"

#include <gtest/gtest.h>

#include <boost/make_shared.hpp>

#include "collision_forge/planner_test/settings/config.h"

namespace forge {
namespace {

constexpr double kNow = 10.0;    // s
constexpr double kSpeed = 10.0;  // m/s of the attacker along x, from x = 0 at now

/// Drives on for 2 s.
collision_forge::Attack attack(const std::string& attacker = "a") {
  collision_forge::Attack message;
  message.trajectory.attacker_id = attacker;
  message.trajectory.header.stamp = ros::Time(kNow);
  message.trajectory.size.x = 4.0;
  message.trajectory.size.y = 2.0;
  for (int i = 0; i <= 20; ++i) {
    message.trajectory.points.emplace_back();
    auto& point = message.trajectory.points.back();
    point.stamp = ros::Time(kNow + 0.1 * i);
    point.pose.position.x = 0.1 * i * kSpeed;
    point.pose.orientation.w = 1.0;
    point.speed = kSpeed;
  }
  return message;
}

/// The attacker, recorded at rest beside its way, and somebody who drives by at 4 m/s.
collision_forge::AgentArray::ConstPtr frame(double time) {
  auto message = boost::make_shared<collision_forge::AgentArray>();
  message->header.stamp = ros::Time(time);
  for (const char* id : {"a", "other"}) {
    message->agents.emplace_back();
    auto& agent = message->agents.back();
    agent.id = id;
    agent.pose.position.y = 50.0;
    agent.pose.orientation.w = 1.0;
  }
  message->agents[1].pose.position.x = 4.0 * time;
  return message;
}

class LiveInjectorTest : public testing::Test {
 protected:
  /// An ego that stands at x = 14, ahead of the attacker, or out of its way.
  void showEgo(double time) {
    injector_.addEgo({time, {14.0, is_in_the_way_ ? 0.0 : 50.0, 0.0}, Vector2::Zero()});
  }

  /// Poses of the ego 20 times, and agents twice a second, each before the others of its time.
  void play(double from, double to) {
    for (int i = 0; from + 0.05 * i <= to + 1e-6; ++i) {
      showEgo(from + 0.05 * i);
      if (i % 10 == 0) injector_.addFrame(frame(from + 0.05 * i));
    }
  }

  std::vector<double> stamps() const {
    std::vector<double> stamps;
    for (const auto& message : published_) stamps.push_back(message.header.stamp.toSec());
    return stamps;
  }

  void expectStamps(const std::vector<double>& expected) const {
    const auto actual = stamps();
    ASSERT_EQ(actual.size(), expected.size()) << testing::PrintToString(actual);
    for (std::size_t i = 0; i < actual.size(); ++i) EXPECT_NEAR(actual[i], expected[i], 1e-6);
  }

  const collision_forge::Agent& agentAt(double time, const std::string& id) const {
    for (const auto& message : published_) {
      if (std::abs(message.header.stamp.toSec() - time) > 1e-6) continue;
      for (const auto& agent : message.agents) {
        if (agent.id == id) return agent;
      }
    }
    throw std::out_of_range(id + " at " + std::to_string(time));
  }

  double attackerAt(double time) const { return agentAt(time, "a").pose.position.x; }

  /// Where the boxes touch: x of the attacker.
  double touchingX() const { return 14.0 - 2.0 - config_.ego_vehicle.size.length / 2.0; }

  LiveInjector injectorThat(AfterContact after) {
    return LiveInjector(config_, after,
                        [this](const auto& message) { published_.push_back(message); });
  }

  const Config config_ = loadConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  std::vector<collision_forge::AgentArray> published_;
  bool is_in_the_way_ = false;
  LiveInjector injector_ = injectorThat(AfterContact::kStop);
};

TEST_F(LiveInjectorTest, WithoutAnAttackFramesPassImmediatelyAndUnchanged) {
  for (const double time : {10.0, 10.5, 10.3, 2.0}) injector_.addFrame(frame(time));
  expectStamps({10.0, 10.5, 10.3, 2.0});
  EXPECT_EQ(published_[1], *frame(10.5));
}

TEST_F(LiveInjectorTest, PublishesAtTheFrameRateOfBagsAndKeepsRecordedStamps) {
  ASSERT_EQ(config_.attacked_bag.frame_rate, 10.0);
  play(9.0, 10.0);
  injector_.setAttack(attack());
  published_.clear();
  play(10.5, 11.0);  // no poses in between: they are not needed
  expectStamps({10.1, 10.2, 10.3, 10.4, 10.5, 10.6, 10.7, 10.8, 10.9, 11.0});
  for (const double time : stamps()) EXPECT_NEAR(attackerAt(time), kSpeed * (time - kNow), 1e-5);
  EXPECT_EQ(agentAt(10.5, "other"), frame(10.5)->agents[1]);
  EXPECT_NEAR(agentAt(10.7, "other").pose.position.x, 4.0 * 10.7, 1e-5);
}

TEST_F(LiveInjectorTest, SupportVehiclesStandWhereTheAttackHasThem) {
  play(9.0, 10.0);
  collision_forge::Attack with_support = attack();
  auto& support = with_support.supports.emplace_back();
  support.role = "parked_vehicle";
  support.motion = attack("parked-1").trajectory;
  support.motion.added = true;
  support.motion.past.resize(1);
  support.motion.past.front().stamp = ros::Time(9.0);
  support.motion.past.front().pose.y = -6.0;
  for (auto& point : support.motion.points) {
    point.pose.position.x = 0.0;
    point.pose.position.y = -6.0;
    point.speed = 0.0;
  }
  injector_.setAttack(with_support);
  published_.clear();
  play(10.5, 11.0);
  for (const double time : stamps()) EXPECT_EQ(agentAt(time, "parked-1").pose.position.y, -6.0);
  injector_.setAttack({});
  published_.clear();
  play(11.5, 11.5);
  EXPECT_THROW(agentAt(11.5, "parked-1"), std::out_of_range);
}

TEST_F(LiveInjectorTest, ASupportVehicleThatDrivesLeavesAtItsLastPoint) {
  play(9.0, 10.0);
  collision_forge::Attack with_support = attack();
  auto& support = with_support.supports.emplace_back();
  support.role = "leader";
  support.motion = attack("leader-1").trajectory;
  support.motion.added = true;
  support.motion.past.resize(1);
  support.motion.past.front().stamp = ros::Time(9.0);
  support.motion.points.resize(6);
  const double last = support.motion.points.back().stamp.toSec();
  injector_.setAttack(with_support);
  published_.clear();
  play(10.5, last + 0.5);
  EXPECT_NO_THROW(agentAt(last, "leader-1"));
  EXPECT_NO_THROW(agentAt(last + 0.1, "a"));
  EXPECT_THROW(agentAt(last + 0.1, "leader-1"), std::out_of_range);
}

TEST_F(LiveInjectorTest, StampsDoNotDependOnTheOrderOfEgoAndAgents) {
  for (const bool is_ego_first : {true, false}) {
    injector_ = injectorThat(AfterContact::kStop);
    play(9.0, 10.0);
    injector_.setAttack(attack());
    published_.clear();
    for (const bool is_ego : {is_ego_first, !is_ego_first}) {
      for (int i = 1; is_ego && i <= 21; ++i) showEgo(10.0 + 0.05 * i);
      for (const double time : {10.5, 11.05}) {
        if (!is_ego) injector_.addFrame(frame(time));
      }
    }
    expectStamps({10.1, 10.2, 10.3, 10.4, 10.5, 10.6, 10.7, 10.8, 10.9, 11.0, 11.05});
  }
}

TEST_F(LiveInjectorTest, FramesWaitForTheEgoAndAreNotExtrapolatedPastARecordedOne) {
  play(9.0, 10.0);
  injector_.setAttack(attack());
  published_.clear();
  showEgo(10.25);
  expectStamps({10.1, 10.2});
  showEgo(10.9);
  expectStamps({10.1, 10.2, 10.3, 10.4});
  injector_.addFrame(frame(10.35));
  expectStamps(
      {10.1, 10.2, 10.3, 10.4, 10.45, 10.55});  // too late for its stamp, and a shorter gap
}

TEST_F(LiveInjectorTest, TheAttackerBrakesToAStandstillFromTheContactOn) {
  is_in_the_way_ = true;
  play(9.0, 10.0);
  injector_.setAttack(attack());
  play(10.5, 14.0);
  const double contact = kNow + touchingX() / kSpeed;
  ASSERT_NEAR(contact, 10.9958, 1e-3);
  EXPECT_NEAR(attackerAt(10.9), 9.0, 1e-5);
  EXPECT_LT(agentAt(11.1, "a").velocity.x, kSpeed - 1.0) << "it has pushed the ego";
  EXPECT_GT(attackerAt(11.1), touchingX());
  EXPECT_NEAR(agentAt(14.0, "a").velocity.x, 0.0, 1e-9);
  EXPECT_EQ(attackerAt(13.9), attackerAt(14.0));
  EXPECT_LT(attackerAt(14.0), 14.0) << "it would have got there without a contact";
}

TEST_F(LiveInjectorTest, ALongerEgoIsTouchedEarlier) {
  is_in_the_way_ = true;
  injector_.setEgoSize({10.0, 2.0});
  play(9.0, 10.0);
  injector_.setAttack(attack());
  play(10.5, 14.0);
  // The boxes touch at x = 14 - 5 - 2, after 0.7 s.
  EXPECT_NEAR(attackerAt(10.6), 6.0, 1e-5);
  EXPECT_LT(agentAt(10.8, "a").velocity.x, kSpeed - 1.0);
}

TEST_F(LiveInjectorTest, WithDriveOnTheAttackerPassesThroughTheEgo) {
  is_in_the_way_ = true;
  injector_ = injectorThat(AfterContact::kDriveOn);
  play(9.0, 10.0);
  injector_.setAttack(attack());
  play(10.5, 12.0);
  EXPECT_NEAR(attackerAt(11.9), 19.0, 1e-5);
}

TEST_F(LiveInjectorTest, AContactBeforeTheAttackArrivesIsFound) {
  is_in_the_way_ = true;
  play(9.0, 11.5);
  injector_.setAttack(attack());
  play(12.0, 14.0);
  EXPECT_NEAR(agentAt(14.0, "a").velocity.x, 0.0, 1e-9);
  EXPECT_LT(attackerAt(14.0), 14.0);
}

TEST_F(LiveInjectorTest, SteppingBackShowsTheAttackAgain) {
  is_in_the_way_ = true;
  play(9.0, 10.0);
  injector_.setAttack(attack());
  play(10.5, 13.0);
  const auto first = published_;
  published_.clear();
  is_in_the_way_ = false;  // this time there is none
  play(9.0, 11.5);
  EXPECT_EQ(published_[1], *frame(9.5));
  EXPECT_NEAR(attackerAt(11.4), 14.0, 1e-5);
  published_.clear();
  is_in_the_way_ = true;
  play(9.0, 13.0);
  EXPECT_NEAR(agentAt(13.0, "a").pose.position.x, first.back().agents[0].pose.position.x, 0.1);
  for (std::size_t i = 1; i < published_.size(); ++i) {
    EXPECT_LT(published_[i - 1].header.stamp, published_[i].header.stamp);
  }
}

TEST_F(LiveInjectorTest, AnAdaptiveAttackerFollowsItsNewestTrajectoryUpToTheContact) {
  is_in_the_way_ = true;
  auto changed = attack();
  for (auto& point : changed.trajectory.points) {
    if (point.stamp > ros::Time(10.5)) point.pose.position.y = 0.5;
  }
  play(9.0, 10.0);
  injector_.setAttack(attack());
  play(10.5, 10.5);
  injector_.setAttack(changed);
  play(11.0, 11.0);
  EXPECT_NEAR(agentAt(10.7, "a").pose.position.y, 0.5, 1e-5);
  EXPECT_NEAR(agentAt(11.0, "a").pose.position.y, 0.5, 1e-5);
  injector_.setAttack(attack());
  play(11.5, 11.5);
  EXPECT_NEAR(agentAt(11.5, "a").pose.position.y, 0.5, 0.1) << "it has crashed";
  published_.clear();
  play(9.0, 11.0);
  EXPECT_NEAR(agentAt(10.7, "a").pose.position.y, 0.0, 1e-5) << "it sets out anew";
}

}  // namespace
}  // namespace forge
