#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/clip_question.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// What is measured on every clip.
struct EvaluationPlan {
  Protocol protocol = Protocol::kStrict;
  std::string method = "recorded";
  bool is_seeded = true;  ///< of the method, if it is no baseline: MethodRegistry::Entry::is_seeded
  Mode mode = Mode::kHistory;
  int seeds = 1;  ///< a seeded method is run with seeds 0 to seeds - 1
  /// Of requests, as in CrashDefinition; clips are judged by rulesOfClips().
  LimitSet limits = LimitSet::kDrivable;
  bool believable = true;
  /// Of clips: what was learned from all scenes is used, the clip's own included, as it is where
  /// splits share scenes; otherwise what was learned without the clip's scene.
  bool seen_scenes = false;
};

/// Of a method that is measured in every plan: "recorded", "constant_velocity" or "nominal".
bool isBaseline(const std::string& method);

/// The plan's methods of clipMethods(): "recorded", "constant_velocity" and "nominal", which are
/// measured in every plan, then its own; before one with networks the same without them. In
/// adaptive mode then "first_plan".
std::vector<std::string> methodsOf(const EvaluationPlan& plan);

/// Rows that evaluateClip() gives, the same for every clip.
std::size_t rowsPerClip(const EvaluationPlan& plan);

/// A row a method, of one that is seeded a row a seed. Methods and the strict protocol take the
/// collision types by the heading alone (rulesOfClips()), and nothing is declined; what came is
/// the clip's own recording. A method without an answer meets nothing. In adaptive mode what a
/// method answers within the drivable limits is the first plan of an AdaptiveAttacker, to which the
/// clip is revealed frame by frame. "first_plan" is what the plan's method answered, not changed
/// any more; baselines drive what they plan. In the published protocol contact_after counts at the
/// nominal 2 Hz. Throws std::invalid_argument as MethodMaker does.
std::vector<ResultRow> evaluateClip(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes,
                                    const ClipEvaluationSetup& setup, const EvaluationPlan& plan);

}  // namespace forge
