#include "collision_forge/study/evaluation/published_planner.h"

#include <gtest/gtest.h>

#include <stdexcept>

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

TEST(PublishedPlanner, TheDrivenEgoReplacesTheRecordedOneFromItsFirstPoint) {
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

TEST(PublishedPlanner, TheTrajectoryReplacesTheRecordedAttackerAfterT0) {
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

TEST(PublishedPlanner, TheProtocolFindsAHitOnlyWithAnEgoInTheAttackersPath) {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 12, 8.0, {-14.7, 0.0, 0.0}, 8.0);
  const auto published = publishedProtocol(clip, protocol());
  EXPECT_TRUE(published->isHit({{clip.now(), {}, 0.0, 0.0, 0.0}}));
  EXPECT_FALSE(published->isHit({{clip.now(), {0.0, 50.0, 0.0}, 0.0, 0.0, 0.0}}));
}

TEST(PublishedPlanner, TheProtocolFindsTheHitOfAnIdmEgo) {
  EXPECT_TRUE(
      publishedProtocol(straightClip(CollisionType::kRearEnd, 0.0, 12, 8.0, {-3.0, 0.0, 0.0}, 8.0),
                        protocol())
          ->isIdmHit(idm()));
}

}  // namespace
}  // namespace forge
