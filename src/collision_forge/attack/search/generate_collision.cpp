#include "collision_forge/attack/search/generate_collision.h"

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/attack/search/alternatives.h"
#include "collision_forge/attack/search/request_check.h"

namespace forge {
namespace {

void addCarefulDrives(const Future& recorded, Attack& attack) {
  attack.report.careful_drivers = driveCarefully(recorded, attack.trajectory);
}

}  // namespace

Attack generateCollision(const AttackMethod& method, const Moment& moment,
                         const CollisionRequest& request, const PredictionOptions& options) {
  Attack answer = generateOne(method, moment, request, options);
  if (answer.status.code == StatusCode::kOk && request.alternatives > 1) {
    answer.alternatives =
        findAlternatives(answer, method, moment, withFullId(request, moment.snapshot), options);
  }
  // Only in replay mode the attack is one on the recorded ego.
  if (answer.status.code == StatusCode::kOk && request.mode == Mode::kReplay && moment.recorded) {
    addCarefulDrives(*moment.recorded, answer);
    for (Attack& other : answer.alternatives) addCarefulDrives(*moment.recorded, other);
  }
  return answer;
}

}  // namespace forge
