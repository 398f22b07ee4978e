#pragma once

#include <memory>

#include "attack/search/test_scenes.h"
#include "collision_forge/planner_test/trials/planner_result.h"
#include "collision_forge/study/evaluation/clip_cases.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {

inline const StudyConfig& config() {
  static const StudyConfig loaded = loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config");
  return loaded;
}

/// The attacker comes from behind at twice the ego's speed.
inline PlannerCase rearEnd() {
  const CollideClip clip =
      straightClip(CollisionType::kRearEnd, 0.0, 11, 5.0, {-14.7, 0.0, 0.0}, 10.0);
  PlannerCase one =
      caseOfClip(clip, ClipAttacker::kRecorded, std::make_shared<const LaneIndex>(twoLaneRoad()),
                 MethodMaker("search", builtInMethods(), config().attack, {}), config());
  one.source = "recorded";
  return one;
}

/// The case tested with two planners.
inline PlannerTestResult tested() {
  return testPlanners(rearEnd(), {{"idm", "idm_published"}}, config(), config().planners);
}

}  // namespace forge
