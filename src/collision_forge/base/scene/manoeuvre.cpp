#include "collision_forge/base/scene/manoeuvre.h"

namespace forge {

const char* toString(Manoeuvre manoeuvre) {
  switch (manoeuvre) {
    case Manoeuvre::kLeadStopped:
      return "lead_stopped";
    case Manoeuvre::kLeadBrakes:
      return "lead_brakes";
    case Manoeuvre::kLeadSlow:
      return "lead_slow";
    case Manoeuvre::kFollowerCloses:
      return "follower_closes";
    case Manoeuvre::kCutIn:
      return "cut_in";
    case Manoeuvre::kDrift:
      return "drift";
    case Manoeuvre::kMerge:
      return "merge";
    case Manoeuvre::kPullOut:
      return "pull_out";
    case Manoeuvre::kCentreLineCrossing:
      return "centre_line_crossing";
    case Manoeuvre::kOvertaking:
      return "overtaking";
    case Manoeuvre::kWrongWay:
      return "wrong_way";
    case Manoeuvre::kStraightCrossing:
      return "straight_crossing";
    case Manoeuvre::kTurnIntoPath:
      return "turn_into_path";
    case Manoeuvre::kTurnAcrossPath:
      return "turn_across_path";
  }
  return "";
}

std::optional<Manoeuvre> manoeuvreFromString(const std::string& name) {
  for (const Manoeuvre manoeuvre : kManoeuvres) {
    if (name == toString(manoeuvre)) return manoeuvre;
  }
  return std::nullopt;
}

}  // namespace forge
