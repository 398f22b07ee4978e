#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/answers/options.h"

namespace forge {

/// Returns true if the lanes of the map allow a request (roadAllows()), for the recorded motion of
/// the ego and the crash definition of `options`. People on foot need no lane: true for them.
bool roadAllowsRequest(const SceneRequest& asked, const IndexedScene& recording,
                       const AnswerOptions& options);

}  // namespace forge
