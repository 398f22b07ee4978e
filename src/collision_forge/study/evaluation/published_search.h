#pragma once

#include <memory>

#include "collision_forge/attack/forecast/ego_futures.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/io/collide/collide_clip.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// Returns the options of a search with the objective of the published protocol: any motion, on or
/// off the road, without vehicle limits or rejections.
AttackOptions withPublishedObjective(AttackOptions options, const EvaluationOptions& evaluation);

/// Returns the conditions of success of that search: rulesOfClips() with the relative heading
/// within `heading_tolerance` of the data set's heading for the type.
CrashDefinition withPublishedObjective(CrashDefinition crash, const NominalOptions& nominal,
                                       const PublishedSearchOptions& options);

/// Returns the trajectory of the clip's attacker with the highest score among nominalAttacker() and
/// the attacks of searchAttacks() with a contact up to `latest` s after t0 + TTA. The score sums
/// over the ego's predicted futures: 1 for a hit in the published protocol, 0.3 more if similar.
/// `recorded`: the recorded future, null in history mode. The angle in the file name is not used.
AttackerTrajectory publishedSearchAttacker(const CollideClip& clip, const Snapshot& snapshot,
                                           const Future* recorded, const CollisionRequest& request,
                                           const LaneIndex& lanes,
                                           std::shared_ptr<const EgoFutureSampler> ego_futures,
                                           const AttackOptions& options,
                                           const EvaluationOptions& evaluation);

}  // namespace forge
