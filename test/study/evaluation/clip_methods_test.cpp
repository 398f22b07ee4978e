#include "collision_forge/study/evaluation/clip_methods.h"

#include <gtest/gtest.h>

#include "collision_forge/io/collide/collide_scene.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {
namespace {

/// Predicts that the attacker ends 4 m behind an ego at (10, 0), or finds no candidate.
class FixedPattern : public AttackMethod {
 public:
  explicit FixedPattern(StatusCode code) : code_(code) {}

  Realization answer(const Moment&, const CollisionRequest&) const override {
    Realization answer;
    answer.status.code = code_;
    answer.aim.attacker_id = "attacker";
    answer.aim.ego.center = {10.0, 0.0, 0.0};
    answer.aim.attacker_offset = {-4.0, 0.0, 0.0};
    return answer;
  }

 private:
  StatusCode code_;
};

/// A rear-end clip with a TTA of 2 s; the attacker drives 10 m/s, 12 m/s in the last frame.
struct Lookahead {
  explicit Lookahead(StatusCode code = StatusCode::kOk) {
    clip.tracks[0].frames.back()->speed = 12.0;
    MethodRegistry methods;
    methods.add({"published_network", "", true,
                 [code](const MethodSetup&) { return std::make_unique<FixedPattern>(code); }});
    registry = clipMethods(methods, &clip, config.evaluation);
  }

  Realization answer() const {
    const Scene scene = toScene(clip, config.evaluation.collide, nullptr);
    const Moment moment{snapshotAt(scene, clip.now(), 8), std::nullopt, nullptr};
    CollisionRequest request;
    request.tta = 2.0;
    MethodSetup setup;
    setup.options = config.attack;
    return registry.at("published_network_lookahead").make(setup)->answer(moment, request);
  }

  StudyConfig config = loadStudyConfig(std::string(COLLISION_FORGE_SOURCE_DIR) + "/config");
  CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
  MethodRegistry registry;
};

TEST(ClipMethods, LookaheadArrivesWithTheMotionOfTheRecordedAttacker) {
  const Lookahead lookahead;
  const Realization answer = lookahead.answer();
  ASSERT_EQ(answer.status.code, StatusCode::kOk);
  const Pose2 reached = poseAt(answer.trajectory, lookahead.clip.now() + 2.0);
  EXPECT_NEAR(reached.x, 6.0, 1e-6);
  const auto at = static_cast<std::size_t>(2.0 / lookahead.config.attack.search.step);
  EXPECT_NEAR(answer.trajectory.points[at].speed, 12.0, 1e-6);
  EXPECT_NEAR(answer.trajectory.points[at - 1].acceleration, (12.0 - 10.0) / 0.5, 1.0);
}

TEST(ClipMethods, LookaheadExistsOnlyWithTheNetwork) {
  const Lookahead lookahead;
  EXPECT_TRUE(lookahead.registry.has("published_network_lookahead"));
  const MethodRegistry without =
      clipMethods(builtInMethods(), &lookahead.clip, lookahead.config.evaluation);
  EXPECT_FALSE(without.has("published_network_lookahead"));
}

}  // namespace
}  // namespace forge
