#include "collision_forge/study/evaluation/published_planner.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const PublishedIdmOptions& idm() {
  static const PublishedIdmOptions options =
      loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config").planners.published_idm;
  return options;
}

const PublishedOptions& protocol() {
  static const PublishedOptions options =
      loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config").evaluation.published;
  return options;
}

const CollideState& egoIn(const CollideClip& clip, std::size_t frame) {
  return *clip.ego().frames[frame];
}

TEST(PublishedPlanner, TheDrivenEgoReplacesTheRecordedOneFromItsFirstPointOn) {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 10, 5.0, {-20.0, 0.0, 0.0}, 5.0);
  const CollideClip driven = withEgo(clip, {{clip.now(), {0.0, 0.0, 0.0}, 8.0, 0.0, 0.0},
                                            {clip.now() + 1.0, {8.0, 1.0, 0.2}, 6.0, 0.0, 0.0}});
  EXPECT_EQ(egoIn(driven, 6).pose.x, egoIn(clip, 6).pose.x);
  EXPECT_NEAR(egoIn(driven, 8).pose.x, 4.0, 1e-6);
  EXPECT_NEAR(egoIn(driven, 8).pose.yaw, 0.1, 1e-6);
  EXPECT_NEAR(egoIn(driven, 9).pose.x, 8.0, 1e-6);
  EXPECT_NEAR(egoIn(driven, 10).pose.x, 8.0, 1e-6);  // stays after the last point
  EXPECT_EQ(driven.attacker().frames[9]->pose.x, clip.attacker().frames[9]->pose.x);
  EXPECT_THROW(withEgo(clip, {}), std::invalid_argument);
}

TEST(PublishedPlanner, TheDrivingAttackerReplacesTheRecordedOneAfterNow) {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 10, 5.0, {-20.0, 0.0, 0.0}, 5.0);
  AttackerTrajectory trajectory{"attacker", AgentClass::kCar, {4.7, 2.0}, {}};
  trajectory.points = {{clip.now(), {-20.0, 0.0, 0.0}, 8.0, 0.0, 0.0},
                       {clip.now() + 1.5, {-8.0, 0.0, 0.0}, 8.0, 0.0, 0.0}};
  const CollideClip driven = withAttacker(clip, trajectory);
  EXPECT_EQ(driven.attacker().frames[7]->speed, 5.0);
  EXPECT_NEAR(driven.attacker().frames[8]->pose.x, -16.0, 1e-6);
  EXPECT_NEAR(driven.attacker().frames[8]->speed, 8.0, 1e-6);
  EXPECT_EQ(egoIn(driven, 10).pose.x, egoIn(clip, 10).pose.x);
}

std::vector<PublishedIdmStep> drivenIn(const CollideClip& clip) {
  return publishedIdmDrive(clip, idm(), protocol());
}

TEST(PublishedPlanner, IdmDrivesEveryStepOfTheClip) {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 10, 10.0, {-1e6, 0.0, 0.0}, 10.0);
  const auto driven = drivenIn(clip);
  ASSERT_EQ(driven.size(), 70u);  // ten intervals of five steps, twenty after
  EXPECT_EQ(driven[0].pose.x, egoIn(clip, 0).pose.x);
  EXPECT_EQ(driven[0].speed, 10.0);
  // Far from the attacker: brakes towards the desired speed of 5 m/s.
  EXPECT_LT(driven[1].speed, 10.0);
  EXPECT_NEAR(driven[1].pose.x, driven[0].pose.x + 0.1 * driven[1].speed, 1e-9);
  EXPECT_NEAR(driven.back().speed, 5.0, 0.01);
}

TEST(PublishedPlanner, TheLeadIsWhereItIsAtTheEndOfTheStep) {
  // The attacker comes towards the ego at 10 m/s, a metre a step.
  CollideClip clip =
      straightClip(CollisionType::kOppositeDirection, 180.0, 10, 5.0, {12.0, 3.0, M_PI}, 10.0);
  const double ego = egoIn(clip, 0).pose.x;
  const double lead = clip.attacker().frames[0]->pose.x - 1.0;
  EXPECT_NEAR(drivenIn(clip)[1].speed,
              publishedIdmSpeed(idm(), 5.0, 10.0, std::hypot(lead - ego, 3.0)), 1e-9);
}

TEST(PublishedPlanner, AfterTheLastFrameTheLeadHasTheSpeedOfTheFrameBeforeIt) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 8, 5.0, {20.0, 0.0, 0.0}, 5.0);
  const auto driven = drivenIn(clip);
  for (CollideTrack& track : clip.tracks) {
    if (track.id == clip.attacker_id) track.frames.back()->speed = 0.0;
  }
  EXPECT_EQ(drivenIn(clip).back().speed, driven.back().speed);
}

TEST(PublishedPlanner, WhereTheRecordedEgoStandsTheDrivenOneStaysToo) {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 10, 0.0, {-1e6, 0.0, 0.0}, 10.0);
  const auto driven = drivenIn(clip);
  EXPECT_EQ(driven.back().pose.x, egoIn(clip, 0).pose.x);
  EXPECT_GT(driven.back().speed, 1.0);
}

TEST(PublishedPlanner, TheProtocolOfACaseSeesTheAttackerHitAnEgoInItsWayAlone) {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 12, 8.0, {-14.7, 0.0, 0.0}, 8.0);
  const auto published = publishedProtocol(clip, protocol());
  EXPECT_TRUE(published->isHit({{clip.now(), {}, 0.0, 0.0, 0.0}}));
  EXPECT_FALSE(published->isHit({{clip.now(), {0.0, 50.0, 0.0}, 0.0, 0.0, 0.0}}));
}

TEST(PublishedPlanner, TheProtocolOfACaseSeesTheAttackerHitTheEgoOfIdm) {
  EXPECT_TRUE(
      publishedProtocol(straightClip(CollisionType::kRearEnd, 0.0, 12, 8.0, {-3.0, 0.0, 0.0}, 8.0),
                        protocol())
          ->isIdmHit(idm()));
}

}  // namespace
}  // namespace forge
