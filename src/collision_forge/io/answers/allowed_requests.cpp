#include "collision_forge/io/answers/allowed_requests.h"

#include "collision_forge/attack/verify/believability.h"

namespace forge {

bool roadAllowsRequest(const SceneRequest& asked, const IndexedScene& recording,
                       const AnswerOptions& options) {
  CollisionRequest request = asked.request;
  request.crash = options.crash;
  return roadAllows(recording.scene.ego, asked.now, request, *recording.lanes,
                    options.attack.verification.believability);
}

}  // namespace forge
