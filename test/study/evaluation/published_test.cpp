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
constexpr int kLastFrameStep = 5 * kLastFrame;

/// The ego stands at the origin; the attacker comes from behind at 8 m/s, 0.8 m a step, and is at
/// `x` at now. Boxes of one heading collide when they overlap by 0.18431 m along their length:
/// 2 o / (2 * 9.4 - 2 o) = 0.02.
CollideClip rearEnd(double x) {
  return straightClip(CollisionType::kRearEnd, 0.0, kLastFrame, 0.0, {x, 0.0, 0.0}, 8.0);
}

/// The attacker's x at which it collides with the standing ego.
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
  // 13.2 m to go after the gap: 16.5 steps of 0.8 m.
  const PublishedOutcome outcome = outcomeOf(rearEnd(kTouch - 13.2));
  EXPECT_TRUE(outcome.isHit());
  EXPECT_EQ(outcome.step, kNowStep + 17);
  EXPECT_EQ(outcome.other_id, "attacker");
  EXPECT_NEAR(outcome.relative_heading, 0.0, 1e-12);
}

TEST(Published, OverlapMustBeAboveTheThreshold) {
  const double step = 0.8;
  EXPECT_EQ(outcomeOf(rearEnd(kTouch - 16.0 * step - 1e-4)).step, kNowStep + 17);
  EXPECT_EQ(outcomeOf(rearEnd(kTouch - 16.0 * step + 1e-4)).step, kNowStep + 16);
}

TEST(Published, HeadingIsHeldFromTheIntervalsStart) {
  CollideClip clip = rearEnd(kTouch - 13.2);  // hits in the interval from frame 10 to 11
  trackOf(clip, "attacker").frames[10]->pose.yaw = 0.05;
  trackOf(clip, "attacker").frames[11]->pose.yaw = 0.5;
  trackOf(clip, "ego").frames[11]->pose.yaw = -0.7;
  const PublishedOutcome outcome = outcomeOf(clip);
  ASSERT_TRUE(outcome.isHit());
  EXPECT_EQ(outcome.step, kNowStep + 17);
  EXPECT_NEAR(outcome.relative_heading, 0.05, 1e-12);
}

TEST(Published, LastFrameAndAfterHaveTheHeadingOfTheFrameBefore) {
  for (const double steps : {20.0, 23.0}) {  // in the last frame, and three steps later
    CollideClip clip = rearEnd(kTouch - (steps - 0.5) * 0.8);
    trackOf(clip, "attacker").frames[10]->pose.yaw = 0.05;
    trackOf(clip, "attacker").frames[11]->pose.yaw = 0.5;
    const PublishedOutcome outcome = outcomeOf(clip);
    ASSERT_TRUE(outcome.isHit());
    EXPECT_EQ(outcome.step, kNowStep + static_cast<int>(steps));
    EXPECT_NEAR(outcome.relative_heading, 0.05, 1e-12);
  }
}

TEST(Published, AfterTheLastFrameTheLastIntervalGoesOn) {
  // The last interval goes sideways, 1 m forward and 4 m left, whatever the heading.
  CollideClip clip = rearEnd(-40.0);
  CollideTrack& track = trackOf(clip, "attacker");
  track.frames[10]->pose = {-3.5, -9.0, 0.0};
  track.frames[11]->pose = {-2.5, -5.0, 0.0};
  // Step k after the last frame: x = -2.5 + 0.2 k, y = -5 + 0.8 k. At k = 4 y = -1.8, the boxes
  // share (4.7 - 1.7) x 0.2 m2 = 0.6: 0.6 / 18.2 = 0.033; at k = 3 y = -2.6 they are apart.
  const PublishedOutcome outcome = outcomeOf(clip);
  ASSERT_TRUE(outcome.isHit());
  EXPECT_EQ(outcome.step, kLastFrameStep + 4);
}

TEST(Published, TwentyStepsAreLookedAtFromTheLastFrameOn) {
  EXPECT_EQ(outcomeOf(rearEnd(kTouch - (20 + 18.5) * 0.8)).step, kLastFrameStep + 19);
  EXPECT_EQ(outcomeOf(rearEnd(kTouch - (20 + 19.5) * 0.8)).event, Event::kNone);
}

TEST(Published, HitBeforeNowCounts) {
  CollideClip clip = rearEnd(-60.0);
  trackOf(clip, "attacker").frames[2]->pose = {1.0, 0.0, 0.0};
  const PublishedOutcome outcome = outcomeOf(clip);
  ASSERT_TRUE(outcome.isHit());
  EXPECT_LE(outcome.step, 10);
  EXPECT_GT(outcome.step, 5);
}

TEST(Published, AttackerThatTouchesAnotherFirstMisses) {
  CollideClip clip = rearEnd(-17.0);
  addStanding(clip, "other", {-9.0, 1.0, 0.0});
  const PublishedOutcome outcome = outcomeOf(clip);
  EXPECT_EQ(outcome.event, Event::kAttackerOther);
  EXPECT_EQ(outcome.other_id, "other");
  EXPECT_FALSE(outcome.isHit());
  EXPECT_FALSE(outcome.similar);
}

TEST(Published, EgoThatTouchesAThirdFirstMakesAMiss) {
  CollideClip clip = rearEnd(-17.0);
  addStanding(clip, "other", {60.0, 0.0, 0.0});
  EXPECT_TRUE(outcomeOf(clip).isHit());
  trackOf(clip, "other").frames[8]->pose = {2.0, 0.0, 0.0};  // drives into the ego's front
  const PublishedOutcome outcome = outcomeOf(clip);
  EXPECT_EQ(outcome.event, Event::kEgoOther);
  EXPECT_EQ(outcome.other_id, "other");
}

TEST(Published, WithinAStepTheOthersComeInTheOrderOfTheirIds) {
  // The attacker drives between the ego and somebody else, 0.1 m into both: once it overlaps them
  // by 3.69 m along, 0.369 / (18.8 - 0.369) = 0.02, both collide in one step.
  for (const auto& [id, event] : {std::pair("aaa", Event::kAttackerOther), {"zzz", Event::kHit}}) {
    CollideClip clip = rearEnd(kTouch - 16.5 * 0.8);
    addStanding(clip, id, {0.0, 1.9, 0.0});
    CollideTrack& ego = trackOf(clip, "ego");
    for (auto& state : ego.frames) state->pose.y = -1.9;
    for (auto& state : trackOf(clip, "attacker").frames) state->pose.y = 0.0;
    const PublishedOutcome outcome = outcomeOf(clip);
    EXPECT_EQ(outcome.event, event) << id;
  }
}

TEST(Published, AttackerAndAThirdComeBeforeEgoAndTheThird) {
  CollideClip clip = rearEnd(-60.0);
  addStanding(clip, "other", {0.0, 60.0, 0.0});
  trackOf(clip, "attacker").frames[0]->pose = {0.0, 2.5, 0.0};
  trackOf(clip, "other").frames[0]->pose = {0.0, 1.5, 0.0};  // on both at once
  const PublishedOutcome outcome = outcomeOf(clip);
  EXPECT_EQ(outcome.event, Event::kAttackerOther);
  EXPECT_EQ(outcome.step, 0);
}

TEST(Published, WhoIsMissingAtEitherEndOfAnIntervalIsNotThere) {
  CollideClip clip = rearEnd(-17.0);
  addStanding(clip, "other", {-9.0, 0.0, 0.0});  // the attacker reaches it in interval 7 to 8
  EXPECT_EQ(outcomeOf(clip).event, Event::kAttackerOther);
  for (const std::size_t missing : {std::size_t{7}, std::size_t{8}}) {
    CollideClip gap = clip;
    CollideTrack& other = trackOf(gap, "other");
    for (std::size_t frame = 0; frame < other.frames.size(); ++frame) {
      // Before the gap it stands there, and there alone.
      if (missing == 7 ? frame <= 7 : frame >= 8) other.frames[frame].reset();
      if (missing == 7 && frame > 7) other.frames[frame]->pose.y = 50.0;
    }
    EXPECT_TRUE(outcomeOf(gap).isHit()) << missing;
  }
}

TEST(Published, WhatOthersDoToEachOtherDoesNotMatter) {
  CollideClip clip = rearEnd(-17.0);
  addStanding(clip, "a", {50.0, 0.0, 0.0});
  addStanding(clip, "b", {51.0, 0.0, 0.0});
  EXPECT_TRUE(outcomeOf(clip).isHit());
}

TEST(Published, SimilarMeansLessThanTenDegreesFromTheNamesAngle) {
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

TEST(Published, AnotherAttackersTrackCountsInPlaceOfTheRecorded) {
  const CollideClip clip = rearEnd(-17.0);
  std::vector<Pose2> away = recordedFrames(clip);
  for (std::size_t frame = kCollideNowFrame + 1; frame < away.size(); ++frame) away[frame].y = 50.0;
  EXPECT_EQ(publishedOutcome(clip, away, kOptions).event, Event::kNone);
  away.pop_back();
  EXPECT_THROW(publishedOutcome(clip, away, kOptions), std::invalid_argument);
}

}  // namespace
}  // namespace forge
