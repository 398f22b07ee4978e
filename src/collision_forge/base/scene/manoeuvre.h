#pragma once

#include <optional>
#include <string>

namespace forge {

/// Attacker manoeuvres, after NHTSA's pre-crash scenarios (Najm, Smith, Yanagisawa 2007, DOT HS 810
/// 767; its scenario numbers in brackets). See manoeuvresOf() for the collision types.
enum class Manoeuvre {
  kLeadStopped,         ///< rear end: stands ahead of the ego (26)
  kLeadBrakes,          ///< rear end: brakes ahead of the ego (25)
  kLeadSlow,            ///< rear end: drives more slowly ahead of the ego (24)
  kFollowerCloses,      ///< rear end: follows the ego and does not brake (22, 25, 26 as follower)
  kCutIn,               ///< lane change: from an adjacent lane (18)
  kDrift,               ///< lane change: beside the ego in its lane, drifting closer (19)
  kMerge,               ///< lane change: its lane merges into the ego's (16)
  kPullOut,             ///< lane change: pulls out from a standstill beside the lanes (17)
  kCentreLineCrossing,  ///< opposite direction: crosses the centre line (21)
  kOvertaking,          ///< opposite direction: overtakes a vehicle ahead of it (20)
  kWrongWay,            ///< opposite direction: drives against the ego's own lanes (21)
  kStraightCrossing,    ///< junction crossing: straight through a red light or stop (4, 5, 30)
  kTurnIntoPath,        ///< junction crossing: turns into the ego's path (28, 31)
  kTurnAcrossPath,      ///< ltap: turns across the ego's path from the opposite direction (27, 29)
  kSameDirectionTurn,   ///< angle: turns across the ego's path from a lane beside it (16)
  kBackOut,             ///< junction crossing: reverses out of a drive or a bay (15)
};

/// All manoeuvres, in the order of the enum.
inline constexpr Manoeuvre kManoeuvres[] = {
    Manoeuvre::kLeadStopped,    Manoeuvre::kLeadBrakes,     Manoeuvre::kLeadSlow,
    Manoeuvre::kFollowerCloses, Manoeuvre::kCutIn,          Manoeuvre::kDrift,
    Manoeuvre::kMerge,          Manoeuvre::kPullOut,        Manoeuvre::kCentreLineCrossing,
    Manoeuvre::kOvertaking,     Manoeuvre::kWrongWay,       Manoeuvre::kStraightCrossing,
    Manoeuvre::kTurnIntoPath,   Manoeuvre::kTurnAcrossPath, Manoeuvre::kSameDirectionTurn,
    Manoeuvre::kBackOut};

/// Returns "lead_stopped", "lead_brakes", ...: the constant's name in lower case.
const char* toString(Manoeuvre manoeuvre);
/// Returns the manoeuvre of a name as toString() spells it; nullopt for another name.
std::optional<Manoeuvre> manoeuvreFromString(const std::string& name);

}  // namespace forge
