#pragma once

#include "collision_forge/answers/options.h"
#include "collision_forge/scene/collision_request.h"
#include "collision_forge/scene/moment.h"

namespace forge {

/// roadAllows() on the ego as it was recorded, for a request of this recording.
bool roadAllowsAsked(const SceneRequest& asked, const IndexedScene& recording,
                     const AnswerOptions& options);

}  // namespace forge
