#pragma once

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/dataset/options.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// The type with the band of headings narrowed to `spread` rad on either side of `heading`, moved
/// into the type's band where it would reach beyond it; `heading` is the nominal one.
TypeDefinition narrowedAbout(const TypeDefinition& definition, double heading, double spread);

/// The heading that a request of a data set is placed at: drawn from the type's band by the
/// request's seed.
double drawnHeading(const CollisionRequest& request, const TypeDefinition& definition);

/// Makes the clip of a request of listClipRequests(). The ego's box at the impact and everybody
/// else are as recorded; candidates are the vehicles recorded in every frame of the clip up to now,
/// and by `choice` vehicles that are added; the attack search of replay mode realises a placement
/// of the type at drawnHeading(), touching within `time_tolerance` of the target time. The answer
/// has code kOk only if
///
/// - strictOutcome() bears it out on the recording, by the full definition of the type;
/// - at most `max_off_road_share` of the attacker is off the road;
/// - it has a clip of COLLIDE's layout that shows the same to a reader, who sees frames at 2 Hz and
///   boxes of one size: a hit in the published protocol, and in the strict one contact, type and
///   time, and nobody touched before.
///
/// Else it has the search's code, or kNoAttackWithinLimits with the reason in the message.
Realization findClip(const SceneRequest& asked, const IndexedScene& indexed,
                     const StudyOptions& study, const DatasetOptions& options);

}  // namespace forge
