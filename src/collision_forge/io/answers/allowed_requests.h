#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/answers/options.h"

namespace forge {

/// Returns true if the lanes of the map allow a request (roadAllows()), for the recorded motion of
/// the ego after t0 = `asked.now`. Uses the crash definition and the plausibility limits of
/// `options`, not the crash definition of the request.
bool roadAllowsRequest(const SceneRequest& asked, const IndexedScene& recording,
                       const AnswerOptions& options);

}  // namespace forge
