#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// Attack method based on a learned traffic generator. Iteratively predicts a few frames for all
/// agents, open loop (arXiv 2510.12206, Sec. 4), and uses only the attacker's trajectory. Ignores
/// vehicle limits. For a request without attacker, tries all candidates; see bestOfCandidates().
/// Thread-safe.
class GeneratorMethod : public AttackMethod {
 public:
  GeneratorMethod(std::shared_ptr<const TrafficGenerator> generator, const AttackOptions& options);

  /// Throws std::runtime_error if the generator returns values that are not finite.
  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  std::shared_ptr<const TrafficGenerator> generator_;
  AttackOptions options_;
};

/// Extends all agents of `clip` from the history to the frame of the crash. Agents without a pose
/// in each frame of the history disappear.
void rollOut(const TrafficGenerator& generator, std::uint64_t seed, TrafficClip& clip);

/// Converts the attacker's frames of a clip, complete up to the frame of the crash, to an attack: a
/// smooth curve through the frames, then straight. `ego` is the ego's pose at t0 (map frame), the
/// origin of the clip; `now` is the index of the frame at t0.
Realization drivenThrough(const TrafficClip& clip, const Pose2& ego, const std::string& attacker,
                          const Moment& moment, const CollisionRequest& request, int now,
                          const AttackOptions& options);

}  // namespace forge
