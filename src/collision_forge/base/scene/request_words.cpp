#include "collision_forge/base/scene/request_words.h"

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {

namespace {

constexpr EnumWord<LimitSet> kLimitWords[] = {
    {LimitSet::kDrivable, "drivable"},
    {LimitSet::kStrict, "strict"},
};

}  // namespace

std::string collisionTypeWords() {
  return "lane_change (LC), opposite_direction (OD, HO, head_on), rear_end (RE), "
         "junction_crossing (JC), ltap (LTAP)";
}

const char* toString(LimitSet limits) { return wordOf(kLimitWords, limits); }

std::optional<LimitSet> limitSetFromString(const std::string& name) {
  return valueOf(kLimitWords, name);
}

std::string manoeuvreNames(CollisionType type) {
  std::string names;
  for (const Manoeuvre manoeuvre : kManoeuvres) {
    if (typeOf(manoeuvre) == type)
      names += (names.empty() ? "" : ", ") + std::string(toString(manoeuvre));
  }
  return names;
}

CollisionType typeOf(Manoeuvre manoeuvre) {
  switch (manoeuvre) {
    case Manoeuvre::kLeadStopped:
    case Manoeuvre::kLeadBrakes:
    case Manoeuvre::kLeadSlow:
    case Manoeuvre::kFollowerCloses:
      break;
    case Manoeuvre::kCutIn:
    case Manoeuvre::kMerge:
    case Manoeuvre::kDrift:
    case Manoeuvre::kPullOut:
      return CollisionType::kLaneChange;
    case Manoeuvre::kCentreLineCrossing:
    case Manoeuvre::kOvertaking:
    case Manoeuvre::kWrongWay:
      return CollisionType::kOppositeDirection;
    case Manoeuvre::kStraightCrossing:
    case Manoeuvre::kTurnIntoPath:
      return CollisionType::kJunctionCrossing;
    case Manoeuvre::kTurnAcrossPath:
      return CollisionType::kLtap;
  }
  return CollisionType::kRearEnd;
}

}  // namespace forge
