#include "collision_forge/answers/allowed_requests.h"

#include "collision_forge/verify/believability.h"

namespace forge {

bool roadAllowsAsked(const SceneRequest& asked, const IndexedScene& recording,
                     const AnswerOptions& options) {
  CollisionRequest request = asked.request;
  request.crash = options.crash;
  return roadAllows(recording.scene.ego, asked.now, request, *recording.lanes,
                    options.attack.verification.believability);
}

}  // namespace forge
