#include "collision_forge/attack/placement.h"

#include <cmath>

namespace forge {
namespace {

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

}  // namespace

std::vector<Placement> placementsOf(CollisionType type, DrivingSide driving_side) {
  switch (type) {
    case CollisionType::kRearEnd:
      return {{Side::kRear, 0.0}, {Side::kFront, 0.0}};
    case CollisionType::kOppositeDirection:
      return {{Side::kFront, 0.0}};
    case CollisionType::kLaneChange:
      return {{Side::kLeft, -1.0}, {Side::kRight, 1.0}};
    case CollisionType::kJunctionCrossing:
      return {{Side::kLeft, -1.0}, {Side::kRight, 1.0}, {Side::kFront, -1.0}, {Side::kFront, 1.0}};
    case CollisionType::kLtap:
      if (driving_side == DrivingSide::kRight) return {{Side::kLeft, -1.0}, {Side::kFront, -1.0}};
      return {{Side::kRight, 1.0}, {Side::kFront, 1.0}};
  }
  return {};
}

Pose2 attackerOffset(const BoxSize& ego, const BoxSize& attacker, Side side, double heading,
                     double slide, double depth) {
  const bool along_x = side == Side::kFront || side == Side::kRear;
  const double half_side = 0.5 * (along_x ? ego.width : ego.length);
  const Vector2 along = along_x ? Vector2(0.0, slide * half_side) : Vector2(slide * half_side, 0.0);
  const OrientedBox ego_box{{}, ego};
  const auto at = [&](double push) {
    const Vector2 position = along + push * outward(side);
    return Pose2{position.x(), position.y(), heading};
  };
  // Bisect between the middle of the side (overlapping) and clear of both circles (apart).
  double inside = 0.0;
  double outside = circumradius(ego) + circumradius(attacker) + std::abs(slide) * half_side;
  constexpr int kHalvings = 40;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (inside + outside);
    (overlaps(ego_box, {at(middle), attacker}) ? inside : outside) = middle;
  }
  return at(inside - depth);
}

}  // namespace forge
