#include "collision_forge/attack/policy/adaptive_answer.h"

#include <utility>

#include "collision_forge/attack/drivers/careful_drive.h"
#include "collision_forge/attack/policy/recorded_drive.h"
#include "collision_forge/attack/search/generate_collision.h"
#include "collision_forge/attack/search/judge.h"

namespace forge {

AdaptiveDrive requestAdaptively(const AttackMethod& method, const Moment& moment,
                                const Scene& recording, const EgoVehicle& ego,
                                const CollisionRequest& request, const AttackerSetup& setup) {
  CollisionRequest likely_or_not = request;
  likely_or_not.crash.min_confidence = 0.0;
  Attack first = generateCollision(method, moment, likely_or_not, setup.attack.prediction);
  if (first.status.code != StatusCode::kOk) return {std::move(first), {}, {}};
  const CollisionRequest driven = withTypeOf(request, first);
  return driveAdaptively(std::move(first), moment, recording, ego, driven, setup);
}

AdaptiveDrive driveAdaptively(Attack first, const Moment& moment, const Scene& recording,
                              const EgoVehicle& ego, const CollisionRequest& request,
                              const AttackerSetup& setup) {
  AdaptiveDrive answer{std::move(first), {}, {}};
  AdaptiveAttacker attacker({moment.snapshot, moment.lanes, ego, request, answer.attack.pattern,
                             answer.attack.trajectory, answer.attack.effort},
                            setup);
  answer.milliseconds = driveOverRecording(attacker, recording, moment.snapshot.now);
  answer.plans = attacker.plans();
  Attack& driven = answer.attack;
  driven.trajectory = attacker.trajectory();
  const double confidence = driven.report.confidence;
  driven.report =
      verify(driven.trajectory, {moment.snapshot, *moment.recorded, request, *moment.lanes},
             setup.attack.verification);
  driven.report.confidence = confidence;
  if (driven.report.contact) {
    driven.report.careful_drivers = driveCarefully(*moment.recorded, driven.trajectory);
    driven.miss =
        missBetween(driven.pattern.attacker_offset,
                    relativeTo(driven.report.ego_at_contact, driven.report.attacker_at_contact));
  }
  return answer;
}

AdaptiveDrive rejectMisses(AdaptiveDrive answer, const CollisionRequest& request) {
  if (answer.attack.status.code != StatusCode::kOk) return answer;
  const std::string shortcoming = shortcomingOf(answer.attack.report, request);
  if (shortcoming.empty()) return answer;
  return {rejection({StatusCode::kNoAttackWithinLimits,
                     "the attacker " + shortcoming +
                         "; its last decision: " + answer.plans.back().reason}),
          {},
          {}};
}

}  // namespace forge
