#pragma once

#include <memory>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/study/generators/traffic_generator.h"

namespace forge {

/// The attacker as a generator drives it. The generator drives everybody, a few frames an
/// iteration, each on what it drove before (open loop, arXiv 2510.12206, Sec. 4); of all that only
/// the attacker's way is taken. No limit of a vehicle is looked at. Without an attacker in the
/// request as bestOfCandidates().
class GeneratorMethod : public AttackMethod {
 public:
  GeneratorMethod(std::shared_ptr<const TrafficGenerator> generator, const AttackOptions& options);

  /// Throws std::runtime_error for a generator that gives numbers that are not finite.
  Realization answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  std::shared_ptr<const TrafficGenerator> generator_;
  AttackOptions options_;
};

/// Drives everybody on from the history up to the frame of the crash. Whoever was not seen
/// throughout the history leaves.
void rollOut(const TrafficGenerator& generator, std::uint64_t seed, TrafficClip& clip);

/// The attacker of a clip that is driven up to the frame of the crash, as an answer: a smooth curve
/// through its frames, then straight on. `ego` is the frame of the clip.
Realization drivenThrough(const TrafficClip& clip, const Pose2& ego, const std::string& attacker,
                          const Moment& moment, const CollisionRequest& request, int now,
                          const AttackOptions& options);

}  // namespace forge
