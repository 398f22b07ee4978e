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

/// Options for a search of what the published protocol counts: a contact at about the angle that
/// the set gives attackers of the type, by any motion, on the road or off it. No vehicle limit is
/// kept and no answer declined.
AttackOptions withPublishedObjective(AttackOptions options, const EvaluationOptions& evaluation);

/// What counts there as the crash: an angle about that of the set, at any time up to the latest, by
/// rulesOfClips().
CrashDefinition withPublishedObjective(CrashDefinition crash, const NominalOptions& nominal,
                                       const PublishedSearchOptions& options);

/// The clip's attacker on that attack (of contacts at any time up to a little after the one asked
/// for) of searchAttacks(), or on nominalAttacker(), that the
/// published protocol would count in most of the ego's futures: hits, and similar ones a third
/// more. `recorded` is null in history mode; the angle in the file's name is never looked at.
AttackerTrajectory publishedSearchAttacker(const CollideClip& clip, const Snapshot& snapshot,
                                           const Future* recorded, const CollisionRequest& request,
                                           const LaneIndex& lanes,
                                           std::shared_ptr<const EgoFutureSampler> ego_futures,
                                           const AttackOptions& options,
                                           const EvaluationOptions& evaluation);

}  // namespace forge
