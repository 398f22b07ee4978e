#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/planner_test/trials/rollout.h"

namespace forge {

/// What an ego does, from an instant on, to confuse who attacks it.
enum class EgoConduct {
  kEvades,    ///< drives one of the plans of EvasiveDrives
  kStops,     ///< stands at once
  kReverses,  ///< drives backwards at once, at 3 m/s
  kJumps,     ///< is 30 m ahead at once, and drives on there
  kVanishes,  ///< is not seen any more
};
inline constexpr std::array<EgoConduct, 5> kEgoConducts = {
    EgoConduct::kEvades, EgoConduct::kStops, EgoConduct::kReverses, EgoConduct::kJumps,
    EgoConduct::kVanishes};
/// "evades", "stops", "reverses", "jumps", "vanishes".
const char* toString(EgoConduct conduct);

/// What became of an attacker.
struct StressOutcome {
  std::string broken_limit;  ///< that it was to keep, by all that it drove; empty where all are
  std::string touched;       ///< whom it touched, the ego aside; empty: nobody
  bool touches_ego = false;
  AttackerPhase phase = AttackerPhase::kAttacking;  ///< at the end
};

/// Drives the setup's attacker to the scenario's end against an ego that drives as recorded, and
/// from a random instant on, within nine tenths of the time asked for, does `conduct`. Both drive
/// on through whom they touch. Deterministic by the seed. Throws as checkScenario().
StressOutcome stressAttacker(const CrashScenario& scenario, const CollisionRequest& request,
                             EgoConduct conduct, std::uint64_t seed, const RolloutSetup& setup);

}  // namespace forge
