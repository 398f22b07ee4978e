#include "collision_forge/trials/published_planner.h"

#include <gtest/gtest.h>

#include <cmath>

#include "collision_forge/settings/config.h"
#include "data/collide_fixture.h"

namespace forge {
namespace {

const PublishedIdmOptions& idm() {
  static const PublishedIdmOptions options =
      loadConfig(COLLISION_FORGE_SOURCE_DIR "/config").planners.published_idm;
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

TEST(PublishedPlanner, IdmDrivesTheWholeClip) {
  // Far from the attacker, from 10 m/s: a = 5 (1 - 2^4) brakes towards 5 m/s from frame 0 on.
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 10, 10.0, {-1e6, 0.0, 0.0}, 10.0);
  const CollideClip driven = withPublishedIdm(clip, idm(), 100.0);
  EXPECT_EQ(egoIn(driven, 0).pose.x, egoIn(clip, 0).pose.x);
  double x = egoIn(clip, 0).pose.x;
  double speed = 10.0;
  for (int step = 0; step < 5; ++step) {
    const double next = std::max(0.0, speed + 0.1 * 5.0 * (1.0 - std::pow(speed / 5.0, 4.0)));
    x += 0.05 * (speed + next);
    speed = next;
  }
  EXPECT_NEAR(egoIn(driven, 1).pose.x, x, 1e-3);
  EXPECT_LT(egoIn(driven, 10).pose.x, egoIn(clip, 10).pose.x - 10.0);
}

TEST(PublishedPlanner, IdmGoesStraightOnAfterItsRecordedPath) {
  // The recorded ego creeps; IDM accelerates past the end of its path.
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 12, 0.2, {-1e6, 0.0, 0.0}, 10.0);
  const CollideClip driven = withPublishedIdm(clip, idm(), 100.0);
  EXPECT_GT(egoIn(driven, 12).pose.x, egoIn(clip, 12).pose.x + 10.0);
  EXPECT_NEAR(egoIn(driven, 12).pose.y, 0.0, 1e-9);
}

}  // namespace
}  // namespace forge
