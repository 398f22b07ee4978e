#include "collision_forge/study/evaluation/clip_aftermath.h"

#include <gtest/gtest.h>

#include "collision_forge/io/collide/collide_scene.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

const Track& trackOf(const Future& future, const std::string& id) {
  for (const Track& track : future.agents) {
    if (track.id == id) return track;
  }
  throw std::out_of_range(id);
}

TEST(ClipAftermath, OnlyTheAttackerStopsAtTheCrash) {
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
  clip.tracks.push_back(straightClipTrack("other", {0.0, 5.0, 0.0}, 4.0, 11));
  const Scene scene = toScene(clip, {{4.7, 2.0}, 2.0, 0.1}, std::make_shared<const LaneMap>());
  const Future recorded = recordedFuture(scene, clip.now());
  const Future stopped = withAttackerStopped(clip, recorded);
  const double crash = clip.times.back();
  const auto at = [](const Future& future, const std::string& id, double time) {
    return stateAt(trackOf(future, id), time)->pose.x;
  };
  EXPECT_NEAR(at(recorded, "attacker", crash + 1.0), 15.3, 1e-6);
  EXPECT_NEAR(at(stopped, "attacker", crash + 1.0), 5.3, 1e-6);
  EXPECT_NEAR(at(stopped, "attacker", crash + 0.2), 5.3, 1e-6);
  EXPECT_NEAR(at(stopped, "attacker", crash - 1.0), -4.7, 1e-6);
  EXPECT_EQ(stateAt(trackOf(stopped, "attacker"), crash + 1.0)->velocity.norm(), 0.0);
  EXPECT_NEAR(at(stopped, "other", crash + 1.0), 12.0, 1e-6);
  EXPECT_EQ(stopped.ego.states.back().pose.x, recorded.ego.states.back().pose.x);
}

}  // namespace
}  // namespace forge
