#pragma once

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/moment.h"

namespace forge {

/// Interface of an attack method: finds an attack for a request. Extension point, see
/// MethodRegistry. Implementations must be immutable: one object is used from many threads at once.
class AttackMethod {
 public:
  virtual ~AttackMethod() = default;

  /// Returns an attack, or a status other than kOk with the reason. Called once per request, and
  /// once per further request of findAlternatives(), on the caller's thread (batch workers call it
  /// concurrently). `request` has passed checkRequest(), its type is not kAny and its crash
  /// definition is filled in; `moment.recorded` is set in replay mode only. Must be deterministic
  /// in its arguments, including the seed. With kOk, `report` must come from verify(); the attack
  /// may still violate the request, which the caller checks. Throws InputError for unusable input;
  /// any other exception ends a batch run, and a live node replies INTERNAL_ERROR. Must not block
  /// on ROS callbacks or change global state.
  virtual Attack answer(const Moment& moment, const CollisionRequest& request) const = 0;
};

/// Returns the method's result, verified or not. Hides `moment.recorded` from the method unless the
/// request is in replay mode. Rejects CollisionType::kAny with kUnknownType, see
/// generateCollision(). Throws as AttackMethod::answer().
Attack attempt(const AttackMethod& method, const Moment& moment, const CollisionRequest& request);

/// Returns one verified attack for a request, ignoring request.alternatives. Rejects without
/// calling the method with the status of checkRequest() if that is not kOk, with kRoadDoesNotAllow
/// if a plausible attack is requested on a map without lanes, and with kNoRecording in replay mode
/// without a recorded future. An attack that violates the request becomes kNoAttackWithinLimits or
/// kNotBelievable. The method's own rejection is returned as it is. The request may shorten its
/// attacker's id (withFullId()). `options`: limits of tta and of candidates. Throws as
/// AttackMethod::answer().
Attack generateOne(const AttackMethod& method, const Moment& moment,
                   const CollisionRequest& request, const PredictionOptions& options);

}  // namespace forge
