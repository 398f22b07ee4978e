#include "collision_forge/base/scene/crash_definition.h"

#include <cmath>

namespace forge {
namespace {

constexpr double kLeastTurn = M_PI / 6.0;  // rad, of an ego that turns at a junction
constexpr double kSkewAcrossArm = 0.5;     // sine of 30 degrees

bool isWithin(double heading, double min, double max) {
  return std::abs(heading) >= min && std::abs(heading) <= max;
}

/// Returns true if the gap between the boxes is larger (or the overlap smaller) along the ego's
/// length than across it.
bool meetsLengthwise(const Pose2& offset, const BoxSize& ego, const BoxSize& attacker) {
  const double cosine = std::abs(std::cos(offset.yaw));
  const double sine = std::abs(std::sin(offset.yaw));
  const double reach_x = 0.5 * (ego.length + attacker.length * cosine + attacker.width * sine);
  const double reach_y = 0.5 * (ego.width + attacker.length * sine + attacker.width * cosine);
  return std::abs(offset.x) - reach_x >= std::abs(offset.y) - reach_y;
}

bool isFlank(Side side) { return side == Side::kLeft || side == Side::kRight; }

}  // namespace

TypeDefinition bandsOf(CollisionType type, Turning turning, const CrashDefinition& crash) {
  const bool ego_turns = turning == Turning::kEgo;
  if (ego_turns && type == CollisionType::kLtap) return crash.ltap_ego_turns;
  TypeDefinition bands = crash.types.at(type);
  if (ego_turns) {
    bands.min_approach = 0.0;
    bands.max_approach = M_PI;
  }
  return bands;
}

CrashDefinition withClipRules(CrashDefinition crash) {
  crash.rules = TypeRules::kAngle;
  crash.limits = LimitSet::kStrict;
  crash.believable = false;
  return crash;
}

bool headingFits(double relative_heading, const TypeDefinition& definition) {
  return isWithin(relative_heading, definition.min_heading, definition.max_heading);
}

bool approachFits(double relative_heading_now, const TypeDefinition& definition) {
  return isWithin(relative_heading_now, definition.min_approach, definition.max_approach);
}

bool contactFits(CollisionType type, const Pose2& offset, const BoxSize& ego,
                 const BoxSize& attacker, DrivingSide driving_side, Turning turning) {
  const OrientedBox ego_box{{}, ego};
  const OrientedBox box{offset, attacker};
  switch (type) {
    case CollisionType::kRearEnd:
      return meetsLengthwise(offset, ego, attacker);
    case CollisionType::kLaneChange:
      return std::abs(offset.y) >= 0.5 * ego.width && offset.y * offset.yaw < 0.0;
    case CollisionType::kLtap:
      return offset.yaw * ltapSign(turning, driving_side) > 0.0;
    case CollisionType::kSideswipeSameDirection:
      return isFlank(touchedSide(ego_box, box)) && isFlank(touchedSide(box, ego_box));
    case CollisionType::kAngleSameDirection:
      return isFlank(touchedSide(ego_box, box)) || isFlank(touchedSide(box, ego_box));
    case CollisionType::kOppositeDirection:
    case CollisionType::kJunctionCrossing:
    case CollisionType::kAngleOppositeDirection:
    case CollisionType::kAny:
      return true;
  }
  return true;
}

double ltapSign(Turning turning, DrivingSide driving_side) {
  return (turning == Turning::kEgo) == (driving_side == DrivingSide::kRight) ? 1.0 : -1.0;
}

bool mayAskForEgoTurn(CollisionType type) {
  return type == CollisionType::kLtap || type == CollisionType::kJunctionCrossing ||
         type == CollisionType::kAngleSameDirection ||
         type == CollisionType::kAngleOppositeDirection;
}

bool egoTurns(CollisionType type, const TurnHeadings& headings, AgentClass attacker,
              const TypeDefinition& definition, DrivingSide driving_side) {
  const double turn = headings.ego_turn;
  if (type == CollisionType::kLtap) {
    const double left = driving_side == DrivingSide::kRight ? turn : -turn;
    return left >= M_PI - definition.max_heading && left > std::abs(headings.attacker_turn);
  }
  if (std::abs(turn) < kLeastTurn) return false;
  if (isOnFoot(attacker) || isCycle(attacker)) {
    return std::abs(std::sin(headings.relative_heading + turn)) <= kSkewAcrossArm;
  }
  return std::abs(turn) > std::abs(headings.attacker_turn);
}

}  // namespace forge
