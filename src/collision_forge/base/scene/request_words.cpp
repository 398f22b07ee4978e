#include "collision_forge/base/scene/request_words.h"

#include <algorithm>
#include <initializer_list>
#include <iterator>

#include "collision_forge/base/geometry/enum_words.h"

namespace forge {

namespace {

constexpr EnumWord<LimitSet> kLimitWords[] = {
    {LimitSet::kDrivable, "drivable"},
    {LimitSet::kStrict, "strict"},
};

constexpr EnumWord<Turning> kTurningWords[] = {
    {Turning::kAttacker, "attacker"},
    {Turning::kEgo, "ego"},
};

constexpr EnumWord<bool> kFlagWords[] = {
    {true, "true"},
    {false, "false"},
};

/// Returns true if `type` is kAny or in the list.
bool isOneOf(CollisionType type, std::initializer_list<CollisionType> types) {
  return type == CollisionType::kAny || std::find(types.begin(), types.end(), type) != types.end();
}

}  // namespace

std::string collisionTypeWords() {
  return "lane_change (LC), opposite_direction (OD, HO, head_on), rear_end (RE), "
         "junction_crossing (JC), ltap (LTAP), sideswipe_same_direction, angle_same_direction, "
         "angle_opposite_direction, any";
}

const char* toString(LimitSet limits) { return wordOf(kLimitWords, limits); }

std::optional<LimitSet> limitSetFromString(const std::string& name) {
  return valueOf(kLimitWords, name);
}

const char* toString(Turning turning) { return wordOf(kTurningWords, turning); }

std::optional<Turning> turningFromString(const std::string& name) {
  return valueOf(kTurningWords, name);
}

bool setRequestWord(const std::string& field, const std::string& word, CollisionRequest& request) {
  const auto set = [&](const auto& value, auto& target) {
    if (value) target = *value;
    return value.has_value();
  };
  if (field == "type") return set(collisionTypeFromString(word), request.type);
  if (field == "choice") return set(attackerChoiceFromString(word), request.choice);
  if (field == "believable") return set(valueOf(kFlagWords, word), request.crash.believable);
  if (field == "limits") return set(limitSetFromString(word), request.crash.limits);
  if (field == "attacker_class") return set(agentClassFromString(word), request.attacker_class);
  if (field == "manoeuvre") return set(manoeuvreFromString(word), request.manoeuvre);
  if (field == "ego_side") return set(sideFromString(word), request.ego_side);
  if (field == "turning") return set(turningFromString(word), request.turning);
  if (field == "from_side") return set(sideFromString(word), request.from_side);
  if (field == "hidden_by") return set(hiderFromString(word), request.hidden_by);
  if (field == "queue") return set(valueOf(kFlagWords, word), request.queue);
  return false;
}

bool isManoeuvreOf(Manoeuvre manoeuvre, CollisionType type, Turning turning) {
  const bool is_ego_turn = type == CollisionType::kLtap && turning == Turning::kEgo;
  switch (manoeuvre) {
    case Manoeuvre::kLeadStopped:
    case Manoeuvre::kLeadBrakes:
    case Manoeuvre::kLeadSlow:
    case Manoeuvre::kFollowerCloses:
      return isOneOf(type, {CollisionType::kRearEnd});
    case Manoeuvre::kMerge:
    case Manoeuvre::kDrift:
      return isOneOf(type, {CollisionType::kLaneChange, CollisionType::kSideswipeSameDirection});
    case Manoeuvre::kCutIn:
    case Manoeuvre::kPullOut:
      return isOneOf(type, {CollisionType::kLaneChange, CollisionType::kSideswipeSameDirection,
                            CollisionType::kAngleSameDirection});
    case Manoeuvre::kCentreLineCrossing:
    case Manoeuvre::kOvertaking:
      return isOneOf(type,
                     {CollisionType::kOppositeDirection, CollisionType::kAngleOppositeDirection});
    case Manoeuvre::kWrongWay:
      return isOneOf(type, {CollisionType::kOppositeDirection});
    case Manoeuvre::kStraightCrossing:
      return is_ego_turn ||
             isOneOf(type, {CollisionType::kJunctionCrossing, CollisionType::kAngleSameDirection,
                            CollisionType::kAngleOppositeDirection});
    case Manoeuvre::kTurnIntoPath:
      return isOneOf(type, {CollisionType::kJunctionCrossing, CollisionType::kAngleSameDirection,
                            CollisionType::kAngleOppositeDirection});
    case Manoeuvre::kTurnAcrossPath:
      return !is_ego_turn &&
             isOneOf(type, {CollisionType::kLtap, CollisionType::kAngleOppositeDirection});
    case Manoeuvre::kSameDirectionTurn:
      return isOneOf(type, {CollisionType::kAngleSameDirection});
    case Manoeuvre::kBackOut:
      return isOneOf(type, {CollisionType::kJunctionCrossing});
  }
  return false;
}

std::vector<Manoeuvre> manoeuvresOf(CollisionType type, Turning turning) {
  std::vector<Manoeuvre> manoeuvres;
  for (const Manoeuvre manoeuvre : kManoeuvres) {
    if (isManoeuvreOf(manoeuvre, type, turning)) manoeuvres.push_back(manoeuvre);
  }
  return manoeuvres;
}

std::string manoeuvreNames(CollisionType type, Turning turning) {
  std::string names;
  for (const Manoeuvre manoeuvre : manoeuvresOf(type, turning)) {
    names += (names.empty() ? "" : ", ") + std::string(toString(manoeuvre));
  }
  return names;
}

CollisionType typeOf(Manoeuvre manoeuvre) {
  return *std::find_if(std::begin(kAllCollisionTypes), std::end(kAllCollisionTypes),
                       [=](CollisionType type) { return isManoeuvreOf(manoeuvre, type); });
}

}  // namespace forge
