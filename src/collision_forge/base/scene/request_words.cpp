#include "collision_forge/base/scene/request_words.h"

#include <algorithm>
#include <cctype>

namespace forge {

std::string lowered(std::string word) {
  std::transform(word.begin(), word.end(), word.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return word;
}

std::string collisionTypeWords() {
  return "lane_change (LC), opposite_direction (OD, HO, head_on), rear_end (RE), "
         "junction_crossing (JC), ltap (LTAP)";
}

const char* toString(LimitSet limits) {
  return limits == LimitSet::kDrivable ? "drivable" : "strict";
}

std::optional<LimitSet> limitSetFromString(const std::string& name) {
  for (const LimitSet limits : {LimitSet::kDrivable, LimitSet::kStrict}) {
    if (name == toString(limits)) return limits;
  }
  return std::nullopt;
}

std::optional<AgentClass> agentClassFromString(const std::string& name) {
  for (auto number = static_cast<int>(AgentClass::kCar);
       number <= static_cast<int>(AgentClass::kStaticObject); ++number) {
    const auto agent_class = static_cast<AgentClass>(number);
    if (name == toString(agent_class)) return agent_class;
  }
  return std::nullopt;
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
