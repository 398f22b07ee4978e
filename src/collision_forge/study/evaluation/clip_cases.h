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

// COLLIDE clips as test cases for planners.

/// The source of the attacker in a COLLIDE clip.
enum class ClipAttacker {
  kRecorded,  ///< the data set's attacker
  kHistory,   ///< made by a method in history mode
  kReplay     ///< made by a method in replay mode
};

/// The attacks of a method that become test cases.
enum class ClipAttacks {
  kVerified,  ///< only attacks that are verified with the configured conditions; the rest is
              ///< rejected
  kAll        ///< all attacks, hit or miss, as in the evaluation on clips (ClipQuestion)
};

/// Returns the test case of a COLLIDE clip, with the data set's box sizes. Attackers made by
/// `method` use the type rules of clips, the relative heading only (withClipRules()). If it finds
/// no attack, PlannerCase::status is its rejection, and attacker and pattern are empty. For
/// kRecorded, the pattern is the recorded relative pose at t0 + TTA, and `method` and `answers` are
/// not used. `lanes`: map of the clip's city, not null. `answers`: the attacks of the method that
/// count. Methods use models trained without the clip's scene.
PlannerCase caseOfClip(const CollideClip& clip, ClipAttacker attacker,
                       std::shared_ptr<const LaneIndex> lanes, const MethodMaker& method,
                       const StudyOptions& study, ClipAttacks answers = ClipAttacks::kVerified);

/// Opens the COLLIDE clips at `paths` as test cases, in this order, named by their files (without
/// folder and ending). `dataroot`: nuScenes root with the maps. `method`: name of the attack
/// method; "" is the default. PlannerCase::source is "recorded", "history" or "replay". `study`
/// must outlive the result. Throws std::invalid_argument for an unknown method; at() throws
/// CollideError for a malformed clip.
std::unique_ptr<PlannerCases> openClipCases(const std::vector<std::string>& paths,
                                            const std::string& dataroot, ClipAttacker attacker,
                                            const std::string& method, ClipAttacks answers,
                                            const StudyOptions& study);

}  // namespace forge
