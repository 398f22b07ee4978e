#pragma once

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/moment.h"
#include "collision_forge/io/answers/options.h"

namespace forge {

/// roadAllows() on the ego as it was recorded, for a request of this recording.
bool roadAllowsAsked(const SceneRequest& asked, const IndexedScene& recording,
                     const AnswerOptions& options);

}  // namespace forge
