#include "collision_forge/io/collide/collide_scene.h"

#include <gtest/gtest.h>

#include "collision_forge/attack/forecast/motion_estimate.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const CollideOptions kOptions{{4.7, 2.0}, 2.0, 0.1};
constexpr int kLastFrame = 11;
constexpr double kRounding = 1e-6;  // m and s; times since 1970 have 1e-7 s

/// An attacker 20 m behind at 8 m/s, and a vehicle at rest beside the road.
CollideClip clipWithThird() {
  CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, kLastFrame, 5.0, {-20.0, 0.0, 0.0}, 8.0);
  clip.tracks.push_back(straightClipTrack("third", {0.0, 10.0, 0.0}, 4.0, kLastFrame));
  return clip;
}

const Track& agent(const std::vector<Track>& agents, const std::string& id) {
  for (const Track& track : agents) {
    if (track.id == id) return track;
  }
  throw std::out_of_range(id);
}

TEST(CollideScene, HistoryOfEgoAndOthersIsAsRecorded) {
  const CollideClip clip = clipWithThird();
  const Snapshot snapshot = snapshotAt(toScene(clip, kOptions, nullptr), clip.now(), 8);
  EXPECT_EQ(snapshot.ego.size.length, 4.7);
  EXPECT_EQ(snapshot.ego.size.width, 2.0);
  ASSERT_EQ(snapshot.ego.states.size(), 8u);
  EXPECT_NEAR(snapshot.ego.states.front().pose.x, -17.5, kRounding);
  ASSERT_EQ(agent(snapshot.agents, "third").states.size(), 8u);
  EXPECT_EQ(agent(snapshot.agents, "third").states.back().time, clip.now());
}

TEST(CollideScene, HidesTheAttackersHistory) {
  CollideClip clip = clipWithThird();
  const Snapshot straight = snapshotAt(toScene(clip, kOptions, nullptr), clip.now(), 8);
  for (std::size_t frame = 0; frame < kCollideNowFrame; ++frame) {
    clip.tracks[0].frames[frame]->pose = {500.0, 77.0 * frame, 1.0};
    clip.tracks[0].frames[frame]->speed = 31.0;
  }
  const Snapshot wild = snapshotAt(toScene(clip, kOptions, nullptr), clip.now(), 8);
  const Track& a = agent(straight.agents, "attacker");
  const Track& b = agent(wild.agents, "attacker");
  ASSERT_EQ(a.states.size(), 2u);
  ASSERT_EQ(b.states.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(a.states[i].time, b.states[i].time);
    EXPECT_EQ(a.states[i].pose.position(), b.states[i].pose.position());
    EXPECT_EQ(a.states[i].velocity, b.states[i].velocity);
  }
}

TEST(CollideScene, AttackersDerivedMotionIsItsRecordedSpeed) {
  CollideClip clip = clipWithThird();
  clip.tracks[0].frames[kCollideNowFrame] = CollideState{{-20.0, 1.0, 2.0}, 6.5};
  const Snapshot snapshot = snapshotAt(toScene(clip, kOptions, nullptr), clip.now(), 8);
  const Motion motion = estimateMotion(agent(snapshot.agents, "attacker"), 4);
  EXPECT_EQ(motion.pose.x, -20.0);
  EXPECT_EQ(motion.pose.yaw, 2.0);
  EXPECT_NEAR(motion.speed, 6.5, 1e-5);
  EXPECT_NEAR(motion.acceleration, 0.0, 1e-9);
  EXPECT_NEAR(motion.yaw_rate, 0.0, 1e-9);
}

TEST(CollideScene, FutureIsRecordedThenConstantVelocity) {
  CollideClip clip = clipWithThird();
  // The ego's last interval: 3 m ahead and 1 m left, heading 0.5 rad.
  CollideState& last = *clip.tracks[1].frames[kLastFrame];
  const Pose2 before = clip.tracks[1].frames[kLastFrame - 1]->pose;
  last.pose = {before.x + 3.0, before.y + 1.0, 0.5};
  const Future future = recordedFuture(toScene(clip, kOptions, nullptr), clip.now());
  EXPECT_EQ(future.ego.states.front().time, clip.now());
  EXPECT_NEAR(future.ego.states.back().time, clip.times.back() + 2.0, kRounding);
  const auto after = stateAt(future.ego, clip.times.back() + 1.25);
  ASSERT_TRUE(after);
  EXPECT_NEAR(after->pose.x, last.pose.x + 2.5 * 3.0, 1e-4);
  EXPECT_NEAR(after->pose.y, last.pose.y + 2.5 * 1.0, 1e-4);
  EXPECT_NEAR(after->pose.yaw, 0.5, 1e-12);
  const auto third = stateAt(agent(future.agents, "third"), clip.times.back() + 2.0);
  ASSERT_TRUE(third);
  EXPECT_NEAR(third->pose.x, 4.0 * 4.0, 1e-4);
  const auto attacker = stateAt(agent(future.agents, "attacker"), clip.times.back());
  ASSERT_TRUE(attacker);
  EXPECT_NEAR(attacker->pose.x, -20.0 + 8.0 * 2.0, 1e-4);
}

}  // namespace
}  // namespace forge
