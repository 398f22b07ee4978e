#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// Disturbance that the ego applies from a given time on to test the robustness of an attacker
/// policy.
enum class EgoConduct {
  kEvades,    ///< drives one of the plans of EvasiveDrives
  kStops,     ///< stops at once
  kReverses,  ///< drives backwards at once, at 3 m/s
  kJumps,     ///< is moved 30 m ahead at once and continues there
  kVanishes,  ///< is no longer observed
};
inline constexpr std::array<EgoConduct, 5> kEgoConducts = {
    EgoConduct::kEvades, EgoConduct::kStops, EgoConduct::kReverses, EgoConduct::kJumps,
    EgoConduct::kVanishes};
/// Returns "evades", "stops", "reverses", "jumps" or "vanishes".
const char* toString(EgoConduct conduct);

/// Result of stressAttacker().
struct StressOutcome {
  std::string
      broken_limit;     ///< limit that the attacker violated over its whole motion; empty if none
  std::string touched;  ///< id of an agent that it touched, the ego excluded; empty if none
  bool touches_ego = false;
  AttackerPhase phase = AttackerPhase::kAttacking;  ///< at the end
};

/// Simulates the setup's attacker to the scenario's end against an ego that drives as recorded and
/// performs `conduct` from a random time within 0.9 of the requested TTA. Contacts do not stop
/// either vehicle. Deterministic for a given `seed`. Throws as checkScenario().
StressOutcome stressAttacker(const CrashScenario& scenario, const CollisionRequest& request,
                             EgoConduct conduct, std::uint64_t seed, const RolloutSetup& setup);

}  // namespace forge
