#pragma once

#include <optional>
#include <string>

namespace forge {

/// What an attacker does that leads to the crash: NHTSA's pre-crash scenarios of the collision
/// types (Najm, Smith, Yanagisawa 2007, DOT HS 810 767; numbers of its scenarios in brackets).
enum class Manoeuvre {
  kLeadStopped,         ///< rear end: stands in front of the ego (26)
  kLeadBrakes,          ///< rear end: brakes in front of the ego (25)
  kLeadSlow,            ///< rear end: drives more slowly in front of the ego (24)
  kFollowerCloses,      ///< rear end: does not brake behind the ego (22, 25, 26 seen from behind)
  kCutIn,               ///< lane change: from a lane beside (18)
  kDrift,               ///< lane change: beside the ego in its lane, nearer and nearer (19)
  kMerge,               ///< lane change: its lane leads into the ego's (16)
  kPullOut,             ///< lane change: from a standstill beside the lanes (17)
  kCentreLineCrossing,  ///< opposite direction: leaves its half of the road (21)
  kOvertaking,          ///< opposite direction: passes somebody ahead of it (20)
  kWrongWay,            ///< opposite direction: comes along the ego's own lanes (21)
  kStraightCrossing,    ///< junction crossing: runs a red light or a stop straight on (4, 5, 30)
  kTurnIntoPath,        ///< junction crossing: turns into the ego's path (28, 31)
  kTurnAcrossPath,      ///< ltap: turns across the ego's path from the opposite direction (27, 29)
};

inline constexpr Manoeuvre kManoeuvres[] = {
    Manoeuvre::kLeadStopped,    Manoeuvre::kLeadBrakes,    Manoeuvre::kLeadSlow,
    Manoeuvre::kFollowerCloses, Manoeuvre::kCutIn,         Manoeuvre::kDrift,
    Manoeuvre::kMerge,          Manoeuvre::kPullOut,       Manoeuvre::kCentreLineCrossing,
    Manoeuvre::kOvertaking,     Manoeuvre::kWrongWay,      Manoeuvre::kStraightCrossing,
    Manoeuvre::kTurnIntoPath,   Manoeuvre::kTurnAcrossPath};

/// "lead_stopped", "lead_brakes", ...
const char* toString(Manoeuvre manoeuvre);
std::optional<Manoeuvre> manoeuvreFromString(const std::string& name);

}  // namespace forge
