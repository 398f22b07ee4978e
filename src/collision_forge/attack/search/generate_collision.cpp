#include "collision_forge/attack/search/generate_collision.h"

#include "collision_forge/attack/search/alternatives.h"
#include "collision_forge/attack/search/request_check.h"

namespace forge {

Attack generateCollision(const AttackMethod& method, const Moment& moment,
                         const CollisionRequest& request, const PredictionOptions& options) {
  Attack answer = generateOne(method, moment, request, options);
  if (answer.status.code == StatusCode::kOk && request.alternatives > 1) {
    answer.alternatives =
        findAlternatives(answer, method, moment, withFullId(request, moment.snapshot), options);
  }
  return answer;
}

}  // namespace forge
