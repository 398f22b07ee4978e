#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/answers/options.h"

namespace forge {

/// Returns roadAllows() for a request, with the recorded ego motion and `options.crash`.
bool roadAllowsAsked(const SceneRequest& asked, const IndexedScene& recording,
                     const AnswerOptions& options);

}  // namespace forge
