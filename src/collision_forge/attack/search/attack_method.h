#pragma once

#include "collision_forge/attack/forecast/options.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/moment.h"

namespace forge {

/// A way of making an attack. Implementations are immutable and may be used from many threads.
class AttackMethod {
 public:
  virtual ~AttackMethod() = default;

  /// The request has passed checkRequest() and says what counts as the crash. `moment.recorded` is
  /// there in replay mode alone. The same input and seed give the same answer. With kOk the report
  /// is that of verify(), and may tell of a crash that is not as asked.
  virtual Realization answer(const Moment& moment, const CollisionRequest& request) const = 0;
};

/// The method's answer, verified or not. In history mode the method is not shown what came.
Realization attempt(const AttackMethod& method, const Moment& moment,
                    const CollisionRequest& request);

/// The way from a request to one verified attack, whatever `alternatives` says. Declines without
/// asking the method what checkRequest() declines, and with kNoRecording a request in replay mode
/// at a moment without a recorded future; an attack that is not verified is kNoAttackWithinLimits.
Realization generateOne(const AttackMethod& method, const Moment& moment,
                        const CollisionRequest& request, const PredictionOptions& options);

}  // namespace forge
