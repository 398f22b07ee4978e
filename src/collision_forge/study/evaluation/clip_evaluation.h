#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/clip_question.h"
#include "collision_forge/study/evaluation/result_row.h"

namespace forge {

/// Defines an evaluation: protocol, method, mode and seeds.
struct EvaluationPlan {
  Protocol protocol = Protocol::kStrict;  ///< protocol that judges the attacks
  /// Method to measure: a name in clipMethods(), for requests in the MethodRegistry.
  std::string method = "recorded";
  bool is_seeded = true;  ///< MethodRegistry::Entry::is_seeded of `method`; unused for baselines
  Mode mode = Mode::kHistory;  ///< in which `method` runs
  int seeds = 1;  ///< number of runs of a seeded method: on clips with seeds 0 to seeds - 1, for
                  ///< requests with the request's seed and the following ones
  /// Requests only, as in CrashDefinition; clips are judged by withClipRules().
  LimitSet limits = LimitSet::kDrivable;
  /// Requests only: attackers must be plausible.
  bool believable = true;
  /// Clips only. True: use models trained on all scenes, including the clip's own, as if splits
  /// shared scenes. False: use models trained without the clip's scene.
  bool seen_scenes = false;
};

/// Returns true for the baselines of every evaluation on clips: "recorded", "constant_velocity" and
/// "nominal".
bool isBaseline(const std::string& method);

/// Returns the methods (names of clipMethods()) that the plan measures: the baselines, the plan's
/// method without networks if it has any, the plan's method, and in adaptive mode "first_plan".
/// Each name occurs once.
std::vector<std::string> methodsOf(const EvaluationPlan& plan);

/// Returns the number of rows of evaluateClip(), which is the same for every clip.
std::size_t rowsPerClip(const EvaluationPlan& plan);

/// Evaluates all methods of the plan on a clip against its recorded future. Returns one row per
/// method of methodsOf(), in that order; for each method but the baselines, if `plan.is_seeded`,
/// one row per seed, ascending. The row of a method without an attack has the status and meets no
/// measure. `lanes`: map of the clip's city.
///
/// - Collision types are judged by the relative heading only (withClipRules()), at any confidence.
/// - Mode adaptive: the attack of a method, found with drivable limits, is the first plan of an
///   AdaptiveAttacker, which observes the clip frame by frame. The row "first_plan" is that attack
///   without replanning. Baselines do not replan.
/// - Published protocol: contact_after is computed at the nominal 2 Hz.
///
/// Thread-safe. Throws std::invalid_argument for an unknown method, as MethodMaker.
std::vector<ResultRow> evaluateClip(const CollideClip& clip, std::shared_ptr<const LaneIndex> lanes,
                                    const ClipEvaluationSetup& setup, const EvaluationPlan& plan);

}  // namespace forge
