#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/planner_test/trials/planner_cases.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

// Clips of COLLIDE as cases that planners are tested on.

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

/// Clips of COLLIDE, named as their files; the source is the attacker's: "recorded", "history" or
/// "replay".
std::unique_ptr<PlannerCases> openClipCases(const std::vector<std::string>& paths,
                                            const std::string& dataroot, ClipAttacker attacker,
                                            const std::string& method, ClipAnswers answers,
                                            const StudyOptions& study);

}  // namespace forge
