#include "collision_forge/attack/search/placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>

namespace forge {
namespace {

constexpr double kParallel = 1e-9;  // cosine; such an axis never separates
constexpr double kMiddle = 1e-6;    // m from the ego's centre: no direction defined

Vector2 outward(Side side) {
  switch (side) {
    case Side::kFront:
      return {1.0, 0.0};
    case Side::kRear:
      return {-1.0, 0.0};
    case Side::kLeft:
      return {0.0, 1.0};
    case Side::kRight:
      return {0.0, -1.0};
  }
  return Vector2::Zero();
}

/// Returns true if the placement contradicts the side from which the attacker is to come.
bool comesFromElsewhere(const Placement& placement, const std::optional<Side>& from) {
  if (!from) return false;
  const bool is_left = *from == Side::kLeft;
  if (placement.side == Side::kLeft || placement.side == Side::kRight) {
    return is_left != (placement.side == Side::kLeft);
  }
  return placement.sign != 0.0 && is_left != (placement.sign < 0.0);
}

}  // namespace

std::vector<Placement> placementsOf(CollisionType type, DrivingSide driving_side, Turning turning) {
  switch (type) {
    case CollisionType::kRearEnd:
      return {{Side::kRear, 0.0}, {Side::kFront, 0.0}};
    case CollisionType::kOppositeDirection:
      return {{Side::kFront, 0.0}};
    case CollisionType::kLaneChange:
      return {{Side::kLeft, -1.0}, {Side::kRight, 1.0}};
    case CollisionType::kSideswipeSameDirection:
      return {{Side::kLeft, 0.0}, {Side::kRight, 0.0}};
    case CollisionType::kJunctionCrossing:
    case CollisionType::kAngleSameDirection:
    case CollisionType::kAngleOppositeDirection:
      return {{Side::kLeft, -1.0}, {Side::kRight, 1.0}, {Side::kFront, -1.0}, {Side::kFront, 1.0}};
    case CollisionType::kLtap:
      if (ltapSign(turning, driving_side) < 0.0) return {{Side::kLeft, -1.0}, {Side::kFront, -1.0}};
      return {{Side::kRight, 1.0}, {Side::kFront, 1.0}};
    case CollisionType::kAny:
      break;
  }
  throw std::invalid_argument("type = any has no placements");
}

std::vector<HeadedPlacement> placementsAlong(double direction, const CollisionRequest& request,
                                             DrivingSide driving_side, double margin,
                                             double max_lean) {
  const TypeDefinition band = request.bands();
  const double low = band.min_heading > kBandEnd ? band.min_heading + margin : 0.0;
  const double high = band.max_heading < M_PI - kBandEnd ? band.max_heading - margin : M_PI;
  const double nearest = std::clamp(std::abs(direction), low, std::max(low, high));
  std::vector<HeadedPlacement> found;
  for (const double sign : {1.0, -1.0}) {
    const double heading = wrapAngle(sign * nearest);
    if (std::abs(angleBetween(direction, heading)) > max_lean) continue;
    for (const Placement& placement : placementsOf(request.type, driving_side, request.turning)) {
      if (placement.sign != 0.0 && placement.sign != sign) continue;
      if (request.ego_side.value_or(placement.side) != placement.side) continue;
      if (comesFromElsewhere(placement, request.from_side)) continue;
      found.push_back({placement.side, heading});
    }
    // At 0 and pi both signs are the same heading.
    if (nearest < kBandEnd || nearest > M_PI - kBandEnd) break;
  }
  return found;
}

double partingDistance(const BoxSize& ego, const BoxSize& attacker, const Pose2& from,
                       const Vector2& direction) {
  const OrientedBox ego_box{{}, ego};
  // The boxes separate along the first axis on which their projections do.
  double parting = std::numeric_limits<double>::infinity();
  for (const AxisGap& side : axisGaps(ego_box, {{0.0, 0.0, from.yaw}, attacker})) {
    const double reach = -side.gap;
    const double rate = side.axis.dot(direction);
    if (std::abs(rate) < kParallel) continue;
    parting =
        std::min(parting, (reach - std::copysign(1.0, rate) * side.axis.dot(from.position())) /
                              std::abs(rate));
  }
  return parting;
}

Pose2 attackerOffset(const BoxSize& ego, const BoxSize& attacker, Side side, double heading,
                     double contact_position, double depth) {
  const bool along_x = side == Side::kFront || side == Side::kRear;
  const double half_side = 0.5 * (along_x ? ego.width : ego.length);
  const Pose2 from{along_x ? 0.0 : contact_position * half_side,
                   along_x ? contact_position * half_side : 0.0, heading};
  const double push = partingDistance(ego, attacker, from, outward(side)) - depth;
  const Vector2 position = from.position() + push * outward(side);
  return {position.x(), position.y(), heading};
}

Pose2 touchingOffset(const BoxSize& ego, const BoxSize& attacker, const Pose2& offset) {
  const double distance = offset.position().norm();
  const Vector2 direction =
      distance > kMiddle ? Vector2(offset.position() / distance) : Vector2(-offset.heading());
  const Vector2 position =
      partingDistance(ego, attacker, {0.0, 0.0, offset.yaw}, direction) * direction;
  return {position.x(), position.y(), offset.yaw};
}

}  // namespace forge
