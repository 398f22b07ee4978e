#include "collision_forge/base/scene/crash_definition.h"

#include <cmath>

namespace forge {
namespace {

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

}  // namespace

CrashDefinition rulesOfClips(CrashDefinition crash) {
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
                 const BoxSize& attacker, DrivingSide driving_side) {
  switch (type) {
    case CollisionType::kRearEnd:
      return meetsLengthwise(offset, ego, attacker);
    case CollisionType::kLaneChange:
      return std::abs(offset.y) >= 0.5 * ego.width && offset.y * offset.yaw < 0.0;
    case CollisionType::kLtap:
      return driving_side == DrivingSide::kRight ? offset.yaw < 0.0 : offset.yaw > 0.0;
    case CollisionType::kOppositeDirection:
    case CollisionType::kJunctionCrossing:
      return true;
  }
  return true;
}

}  // namespace forge
