#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/data/collide_clip.h"
#include "collision_forge/map/lane_queries.h"
#include "collision_forge/network/foresight.h"
#include "collision_forge/settings/config.h"
#include "collision_forge/study/result_row.h"

namespace forge {

/// What is measured on every clip.
struct EvaluationPlan {
  Protocol protocol = Protocol::kStrict;
  std::string method = "recorded";
  Mode mode = Mode::kHistory;
  int seeds = 1;  ///< a search is run with seeds 0 to seeds - 1
  /// Of clips: what was learned from all scenes is used, the clip's own included, as it is where
  /// splits share scenes; otherwise what was learned without the clip's scene.
  bool seen_scenes = false;
};

/// "recorded", "constant_velocity", "nominal" (protocols/baselines.h), which every plan measures
/// beside its method; without learning "search" (attack/generator.h) and "published_search"
/// (protocols/published_search.h), with the pattern networks "network+search",
/// "network+published_search" and "network": patternAttacker() to the likeliest pattern.
const std::vector<std::string>& evaluationMethods();

/// The plan's methods: those measured in every plan, then its own; before a search with networks
/// the same without them.
std::vector<std::string> methodsOf(const EvaluationPlan& plan);

/// True for the methods of evaluationMethods() that need pattern networks.
bool needsNetworks(const std::string& method);
/// Throws std::invalid_argument for such a method without networks.
void checkNetworks(const std::string& method, const Foresight& foresight);

/// Rows that evaluateClip() gives, the same for every clip.
std::size_t rowsPerClip(const EvaluationPlan& plan);

/// A row a method, the search a row a seed. The search and the strict protocol take the collision
/// types by the heading alone (withAngleRules()); what came is the clip's own recording. A method
/// without an answer meets nothing. In the published protocol contact_after counts at the nominal 2
/// Hz. Throws std::invalid_argument for an unknown method and for one that needs networks when
/// there are none.
std::vector<ResultRow> evaluateClip(const CollideClip& clip, const LaneIndex& lanes,
                                    std::shared_ptr<const LaneMap> map, const Foresight& foresight,
                                    const Config& config, const EvaluationPlan& plan);

}  // namespace forge
