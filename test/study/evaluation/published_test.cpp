#include "collision_forge/study/evaluation/published.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "collision_forge/study/evaluation/clip_attackers.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

using Event = PublishedOutcome::Event;

constexpr double kDegree = M_PI / 180.0;
const PublishedOptions kOptions{{4.7, 2.0}, 0.02, 5, 20, 10.0 * kDegree};
constexpr int kLastFrame = 11;
constexpr int kNowStep = 5 * kCollideNowFrame;

/// The ego stands at the origin; the attacker comes from behind at 8 m/s, 0.8 m a step, and is at
/// `x` at now. Boxes of one heading collide when they overlap by 0.18431 m along their length:
/// 2 o / (2 * 9.4 - 2 o) = 0.02.
CollideClip rearEnd(double x) {
  return straightClip(CollisionType::kRearEnd, 0.0, kLastFrame, 0.0, {x, 0.0, 0.0}, 8.0);
}

/// Returns the attacker's x at which it collides with the standing ego.
constexpr double kTouch = -4.7 + 0.18431;

PublishedOutcome outcomeOf(const CollideClip& clip) {
  return publishedOutcome(clip, recordedFrames(clip), kOptions);
}

CollideTrack& trackOf(CollideClip& clip, const std::string& id) {
  for (CollideTrack& track : clip.tracks) {
    if (track.id == id) return track;
  }
  throw std::out_of_range(id);
}

void addStanding(CollideClip& clip, const std::string& id, const Pose2& pose) {
  clip.tracks.push_back(standingClipTrack(id, pose, clip.collision_frame));
}

TEST(Published, HitIsAtTheFirstStepWithEnoughOverlap) {
  // 13.2 m remain after the gap: 16.5 steps of 0.8 m.
  const PublishedOutcome outcome = outcomeOf(rearEnd(kTouch - 13.2));
  EXPECT_TRUE(outcome.isHit());
  EXPECT_EQ(outcome.step, kNowStep + 17);
  EXPECT_EQ(outcome.other_id, "attacker");
  EXPECT_NEAR(outcome.relative_heading, 0.0, 1e-12);
}

TEST(Published, AnEarlierContactOfTheAttackerIsAMiss) {
  CollideClip clip = rearEnd(-17.0);
  addStanding(clip, "other", {-9.0, 1.0, 0.0});
  const PublishedOutcome outcome = outcomeOf(clip);
  EXPECT_EQ(outcome.event, Event::kAttackerOther);
  EXPECT_EQ(outcome.other_id, "other");
  EXPECT_FALSE(outcome.isHit());
  EXPECT_FALSE(outcome.similar);
}

TEST(Published, AnEarlierContactOfTheEgoIsAMiss) {
  CollideClip clip = rearEnd(-17.0);
  addStanding(clip, "other", {60.0, 0.0, 0.0});
  EXPECT_TRUE(outcomeOf(clip).isHit());
  trackOf(clip, "other").frames[8]->pose = {2.0, 0.0, 0.0};  // drives into the ego's front
  const PublishedOutcome outcome = outcomeOf(clip);
  EXPECT_EQ(outcome.event, Event::kEgoOther);
  EXPECT_EQ(outcome.other_id, "other");
}

TEST(Published, SimilarIsWithinTenDegreesOfTheAngleInTheFileName) {
  CollideClip clip = rearEnd(-17.0);
  for (auto& state : trackOf(clip, "attacker").frames) state->pose.yaw = -20.0 * kDegree;
  for (const auto& [angle, similar] :
       {std::pair(9.9, false), {10.1, true}, {20.0, true}, {29.9, true}, {30.1, false}}) {
    clip.angle = angle * kDegree;
    const PublishedOutcome outcome = outcomeOf(clip);
    ASSERT_TRUE(outcome.isHit());
    EXPECT_NEAR(outcome.relative_heading, 20.0 * kDegree, 1e-12);
    EXPECT_EQ(outcome.similar, similar) << angle;
  }
}

TEST(Published, AGivenAttackerTrackReplacesTheRecordedOne) {
  const CollideClip clip = rearEnd(-17.0);
  std::vector<Pose2> away = recordedFrames(clip);
  for (std::size_t frame = kCollideNowFrame + 1; frame < away.size(); ++frame) away[frame].y = 50.0;
  EXPECT_EQ(publishedOutcome(clip, away, kOptions).event, Event::kNone);
  away.pop_back();
  EXPECT_THROW(publishedOutcome(clip, away, kOptions), std::invalid_argument);
}

}  // namespace
}  // namespace forge
