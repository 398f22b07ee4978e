#include "collision_forge/study/evaluation/clip_attackers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/search/baselines.h"
#include "collision_forge/attack/search/quintic.h"
#include "collision_forge/io/collide/collide_scene.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const BoxSize kBox{4.7, 2.0};
const CollideOptions kCollide{kBox, 2.0, 0.1};
const NominalOptions kNominal{4.0, 3.0, 2.0, 1.0, 0.35};
constexpr int kLastFrame = 13;  // 3 s from now
constexpr double kRounding = 1e-6;

const SearchOptions& search() {
  static const AttackOptions options = shippedOptions();
  return options.search;
}

/// A clip in which the attacker follows one quintic per axis from frame 0 to the last.
CollideClip quinticClip() {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, kLastFrame, 5.0, {}, 5.0);
  const double duration = 0.5 * kLastFrame;
  const Quintic x({1000.0, 8.0, 0.0}, {1050.0, 4.0, 0.0}, duration);
  const Quintic y({500.0, 0.0, 0.0}, {512.0, 5.0, 0.0}, duration);
  for (int frame = 0; frame <= kLastFrame; ++frame) {
    const AxisState at_x = x.at(0.5 * frame);
    const AxisState at_y = y.at(0.5 * frame);
    const double yaw = std::atan2(at_y.velocity, at_x.velocity);
    clip.tracks[0].frames[frame] =
        CollideState{{at_x.position, at_y.position, yaw}, std::hypot(at_x.velocity, at_y.velocity)};
  }
  return clip;
}

AttackOptions nominalOptions() {
  AttackOptions options = shippedOptions();
  options.nominal = kNominal;
  return options;
}

struct Nominal {
  CollideClip clip;
  AttackOptions options = nominalOptions();
  Mode mode = Mode::kHistory;

  AttackerTrajectory trajectory() const {
    const Scene scene = toScene(clip, kCollide, nullptr);
    const Future recorded = recordedFuture(scene, clip.now());
    return nominalAttacker(clip.attacker_id, snapshotAt(scene, clip.now(), 8),
                           mode == Mode::kReplay ? &recorded : nullptr,
                           requestOf(clip, mode, 0.5, shippedCrash()), options);
  }
  /// Position of the attacker at the last frame.
  TrajectoryPoint end() const {
    for (const TrajectoryPoint& point : trajectory().points) {
      if (point.time >= clip.times.back() - 1e-3) return point;
    }
    throw std::out_of_range("the trajectory ends before the last frame");
  }
};

/// The ego drives along x at 5 m/s and is at (15, 0) in the last frame.
Nominal nominal(CollisionType type, double attacker_y) {
  return {straightClip(type, 0.0, kLastFrame, 5.0, {-10.0, attacker_y, 0.0}, 7.0)};
}

void expectPose(const Pose2& actual, double x, double y, double yaw) {
  EXPECT_NEAR(actual.x, x, 1e-3);
  EXPECT_NEAR(actual.y, y, 1e-3);
  EXPECT_NEAR(angleBetween(yaw, actual.yaw), 0.0, 1e-6);
}

TEST(Baselines, RequestHasTypeTtaAndAttackerOfTheClip) {
  CollideClip clip = straightClip(CollisionType::kLtap, 90.0, kLastFrame, 5.0, {}, 5.0);
  CollisionRequest request = requestOf(clip, Mode::kReplay, 0.5, shippedCrash());
  EXPECT_EQ(request.type, CollisionType::kLtap);
  EXPECT_NEAR(request.tta, 3.0, kRounding);
  EXPECT_EQ(request.attacker, "attacker");
  EXPECT_EQ(request.mode, Mode::kReplay);
  clip = straightClip(CollisionType::kLtap, 90.0, 8, 5.0, {}, 5.0);
  clip.times.back() -= 0.1;
  EXPECT_EQ(requestOf(clip, Mode::kReplay, 0.5, shippedCrash()).tta, 0.5);
}

TEST(Baselines, RecordedAttackerFollowsItsQuintic) {
  const CollideClip clip = quinticClip();
  const AttackerTrajectory trajectory = recordedAttacker(clip, kBox, search());
  const double duration = 0.5 * kLastFrame;
  const Quintic x({1000.0, 8.0, 0.0}, {1050.0, 4.0, 0.0}, duration);
  const Quintic y({500.0, 0.0, 0.0}, {512.0, 5.0, 0.0}, duration);
  ASSERT_EQ(trajectory.points.size(), 30u + 1u + 20u);
  EXPECT_EQ(trajectory.points.front().time, clip.now());
  EXPECT_EQ(trajectory.points[30].time, clip.times.back());
  for (std::size_t i = 0; i <= 30; ++i) {
    const TrajectoryPoint& point = trajectory.points[i];
    const AxisState at_x = x.at(point.time - clip.times[0]);
    const AxisState at_y = y.at(point.time - clip.times[0]);
    const double speed = std::hypot(at_x.velocity, at_y.velocity);
    EXPECT_NEAR(point.pose.x, at_x.position, 1e-5);
    EXPECT_NEAR(point.pose.y, at_y.position, 1e-5);
    EXPECT_NEAR(angleBetween(std::atan2(at_y.velocity, at_x.velocity), point.pose.yaw), 0.0, 0.02);
    EXPECT_NEAR(point.speed, speed, 1e-2);
    EXPECT_NEAR(point.acceleration,
                (at_x.velocity * at_x.acceleration + at_y.velocity * at_y.acceleration) / speed,
                5e-2);
    EXPECT_NEAR(point.curvature,
                (at_x.velocity * at_y.acceleration - at_y.velocity * at_x.acceleration) /
                    std::pow(speed, 3),
                1e-4);
  }
}

TEST(Baselines, RecordedMotionDependsOnlyOnTheSixNearestFrames) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, kLastFrame, 5.0, {}, 5.0);
  for (const std::size_t frame : {std::size_t{4}, std::size_t{13}}) {
    clip.tracks[0].frames[frame]->pose.y = 1.0;
  }
  const AttackerTrajectory trajectory = recordedAttacker(clip, kBox, search());
  for (std::size_t i = 0; i < 15;
       ++i) {  // up to frame 10, the first interval that depends on frame 13
    EXPECT_NEAR(trajectory.points[i].curvature, 0.0, 1e-6) << i;
  }
  EXPECT_GT(std::abs(trajectory.points[25].curvature), 1e-3);
}

TEST(Baselines, RecordedAttackerContinuesStraightAfterTheLastFrame) {
  const CollideClip clip = quinticClip();
  const AttackerTrajectory trajectory = recordedAttacker(clip, kBox, search());
  const TrajectoryPoint& last = trajectory.points[30];
  const TrajectoryPoint& end = trajectory.points.back();
  EXPECT_NEAR(end.time, clip.times.back() + 2.0, kRounding);
  expectPose(end.pose, last.pose.x + 2.0 * last.speed * std::cos(last.pose.yaw),
             last.pose.y + 2.0 * last.speed * std::sin(last.pose.yaw), last.pose.yaw);
  EXPECT_EQ(end.acceleration, 0.0);
}

TEST(Baselines, ConstantVelocityUsesTheHistoryOfTheAgent) {
  const Snapshot snapshot = snapshotOf(pastTrack(kEgoId, kEgoSize, {}, 5.0),
                                       {pastTrack("other", kCarSize, {}, 1.0),
                                        pastTrack("attacker", kCarSize, {3.0, 4.0, M_PI_2}, 6.0)},
                                       emptyMap());
  const AttackerTrajectory trajectory =
      constantVelocityAttacker("attacker", snapshot, 3.0, shippedOptions());
  EXPECT_EQ(trajectory.attacker_id, "attacker");
  EXPECT_EQ(trajectory.size.length, kCarSize.length);
  EXPECT_EQ(trajectory.points.front().time, kNow);
  EXPECT_NEAR(trajectory.points.back().time, kNow + 5.0, kRounding);
  expectPose(trajectory.points.back().pose, 3.0, 4.0 + 6.0 * 5.0, M_PI_2);
  EXPECT_NEAR(trajectory.points.back().speed, 6.0, 1e-9);
  EXPECT_THROW(constantVelocityAttacker("nobody", snapshot, 3.0, shippedOptions()),
               std::invalid_argument);
}

TEST(Baselines, NominalPosesAreThePublishedOnes) {
  expectPose(nominal(CollisionType::kRearEnd, 0.5).end().pose, 11.0, 0.0, 0.0);
  expectPose(nominal(CollisionType::kOppositeDirection, 0.5).end().pose, 19.0, 0.0, M_PI);
  expectPose(nominal(CollisionType::kJunctionCrossing, 6.0).end().pose, 15.0, 3.0, -M_PI_2);
  expectPose(nominal(CollisionType::kJunctionCrossing, -6.0).end().pose, 15.0, -3.0, M_PI_2);
  expectPose(nominal(CollisionType::kLtap, 6.0).end().pose, 15.0, 3.0, -M_PI_2);
  const double side = 1.0 + std::cos(0.35);
  const double ahead = 15.0 + 2.0 + std::sin(0.35);
  expectPose(nominal(CollisionType::kLaneChange, 3.0).end().pose, ahead, side, -0.35);
  expectPose(nominal(CollisionType::kLaneChange, -3.0).end().pose, ahead, -side, 0.35);
}

TEST(Baselines, NominalUsesTheEgoFutureOfItsMode) {
  Nominal attack = nominal(CollisionType::kRearEnd, 0.0);
  for (int frame = kCollideNowFrame + 1; frame <= kLastFrame; ++frame) {
    attack.clip.tracks[1].frames[frame]->pose.y = 2.0;  // unknown at t0
  }
  expectPose(attack.end().pose, 11.0, 0.0, 0.0);
  attack.mode = Mode::kReplay;
  expectPose(attack.end().pose, 11.0, 2.0, 0.0);
}

TEST(Baselines, FramesAreRecordedUpToT0ThenOnTheTrajectory) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, kLastFrame, 5.0, {}, 5.0);
  clip.tracks[0].frames[3]->pose.y = 9.0;
  AttackerTrajectory trajectory = constantVelocityAttacker(clip, kBox, search());
  for (TrajectoryPoint& point : trajectory.points) point.pose.y = 2.0 * (point.time - clip.now());
  const std::vector<Pose2> frames = framesOf(clip, trajectory);
  ASSERT_EQ(frames.size(), static_cast<std::size_t>(kLastFrame + 1));
  EXPECT_EQ(frames[3].y, 9.0);
  EXPECT_EQ(frames[kCollideNowFrame].y, 0.0);
  for (int frame = kCollideNowFrame + 1; frame <= kLastFrame; ++frame) {
    EXPECT_NEAR(frames[frame].y, 1.0 * (frame - kCollideNowFrame), 1e-5);
    EXPECT_NEAR(frames[frame].x, 2.5 * (frame - kCollideNowFrame), 1e-5);
  }
}

}  // namespace
}  // namespace forge
