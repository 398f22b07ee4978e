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
  /// Keeps the generator alive; copies `options`.
  GeneratorMethod(std::shared_ptr<const TrafficGenerator> generator, const AttackOptions& options);

  /// Returns the attack, verified or not; see AttackMethod. Throws std::runtime_error if the
  /// generator returns values that are not finite.
  Attack answer(const Moment& moment, const CollisionRequest& request) const override;

 private:
  std::shared_ptr<const TrafficGenerator> generator_;
  AttackOptions options_;
};

/// Replaces the frames of all agents of `clip` after t0 (index history_frames - 1) by predictions,
/// in calls of the generator that add future_frames frames each, until the frame of the crash
/// exists: the last call may add up to future_frames - 1 beyond. `seed` determines the random
/// numbers. An agent without a pose in each frame of the history (ending at the newest frame so
/// far) is absent from then on. Throws std::runtime_error if a prediction is not finite.
void rollOut(const TrafficGenerator& generator, std::uint64_t seed, TrafficClip& clip);

/// Converts the attacker's frames of a clip, complete up to the frame of the crash, to an attack: a
/// smooth curve through the frames, which are taken as evenly spaced over the TTA, then straight
/// for SearchOptions::tail s. `ego` is the ego's pose at t0 (map frame), the origin of the clip;
/// `attacker` is the attacker's id in the snapshot; `now` is the index of the frame at t0. Pattern
/// and report come from drivenAttack().
Attack drivenThrough(const TrafficClip& clip, const Pose2& ego, const std::string& attacker,
                     const Moment& moment, const CollisionRequest& request, int now,
                     const AttackOptions& options);

}  // namespace forge
