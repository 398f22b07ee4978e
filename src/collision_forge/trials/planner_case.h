#pragma once

#include <memory>
#include <optional>
#include <string>

#include "collision_forge/data/collide_clip.h"
#include "collision_forge/data/scenario_file.h"
#include "collision_forge/data/scene_source.h"
#include "collision_forge/network/method_maker.h"
#include "collision_forge/study/options.h"
#include "collision_forge/trials/crash_scenario.h"

namespace forge {

/// A crash that planners are tested on, wherever it comes from.
struct PlannerCase {
  std::string name;    ///< of the clip, or of the scenario's line
  std::string source;  ///< of scenarios: the tables have a row each
  std::string scene;   ///< what the intervals are clustered by
  CollisionRequest request;
  Status status;                    ///< why there is nothing to test on, where there is not
  CrashScenario scenario;           ///< with kOk only, but snapshot.now always
  CollisionPattern pattern;         ///< aimed at; with kOk only
  double effort = 0.0;              ///< Realization::effort
  std::optional<CollideClip> clip;  ///< that it is of, its attacker as it drives here
};

/// A line of a scenario file over its scene. Declined answers keep their status; kNoScene where
/// the scene has no frame at its time.
PlannerCase caseOfScenario(const Scenario& scenario, const IndexedScene& indexed,
                           const StudyOptions& study);

/// Who attacks in a clip of COLLIDE: the set's own attacker, or ours on the set's request.
enum class ClipAttacker { kRecorded, kHistory, kReplay };

/// Which answers of a method attack in clips.
enum class ClipAnswers {
  kVerified,  ///< a crash as asked, declined as the configuration says
  kAll        ///< as the evaluation on clips judges them (ClipQuestion), hit or miss
};

/// A clip of COLLIDE, boxes as the set's. Ours are searched by the heading alone (rulesOfClips()).
PlannerCase caseOfClip(const CollideClip& clip, ClipAttacker attacker,
                       std::shared_ptr<const LaneIndex> lanes, const MethodMaker& method,
                       const StudyOptions& study, ClipAnswers answers = ClipAnswers::kVerified);

}  // namespace forge
