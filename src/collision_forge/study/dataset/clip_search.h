#pragma once

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/crash_definition.h"
#include "collision_forge/io/logs/scene_source.h"
#include "collision_forge/study/dataset/options.h"
#include "collision_forge/study/evaluation/options.h"

namespace forge {

/// Returns the type with its heading band at contact narrowed to `heading` +- `spread` (rad), or
/// less if the type's own band is narrower. A band that would exceed the type's own band is shifted
/// into it. `heading`, within the type's own band, becomes the nominal heading.
TypeDefinition narrowedAbout(const TypeDefinition& definition, double heading, double spread);

/// Returns a relative heading at contact (rad), uniformly distributed over the type's heading band,
/// drawn with the seed of the request.
double drawnHeading(const CollisionRequest& request, const TypeDefinition& definition);

/// Searches the attack for a request of listClipRequests(), in replay mode: ego and other agents
/// move as recorded. Candidates are the vehicles recorded in every frame of the clip up to t0 and,
/// depending on `options.choice`, added vehicles. The contact must come within `time_tolerance` of
/// the target time at about drawnHeading().
///
/// Returns an attack with code kOk only if
/// - strictOutcome() on the recording meets the full definition of the type;
/// - the attacker's off_road_share is at most `max_off_road_share`;
/// - it can be written as a clip in COLLIDE's layout (2 Hz, one box size), and that clip is a hit
///   in the published protocol and has contact, type and time in the strict one, without an earlier
///   contact.
///
/// Otherwise returns a rejection: with the status of momentAt() or the search, or
/// kNoAttackWithinLimits with the condition that the attack does not meet as message.
Attack findClip(const SceneRequest& asked, const IndexedScene& indexed, const StudyOptions& study,
                const DatasetOptions& options);

}  // namespace forge
