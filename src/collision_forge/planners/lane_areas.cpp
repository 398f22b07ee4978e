#include "collision_forge/planners/lane_areas.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace forge {
namespace {

constexpr double kRightAngle = M_PI / 2.0;

}  // namespace

LaneAreas::LaneAreas(const LaneIndex& lanes, const Vector2& center, double radius) : lanes_(lanes) {
  for (const std::size_t lane : lanes.lanesWithin(center, radius)) {
    const std::vector<Vector2>& outline = lanes.map().lanes[lane].polygon;
    if (outline.size() < 3) continue;
    areas_.push_back({lane, {outline, {}}, {}});
    for (const Vector2& point : outline) areas_.back().bounds.extend(point);
  }
}

bool LaneAreas::inSeveralLanes(const OrientedBox& box) const {
  const std::array<Vector2, 4> outline = corners(box);
  int lanes = 0;
  for (const Area& area : areas_) {
    const auto inside = std::count_if(outline.begin(), outline.end(),
                                      [&](const Vector2& corner) { return isIn(area, corner); });
    if (inside == static_cast<std::ptrdiff_t>(outline.size())) return false;
    lanes += inside > 0;
  }
  return lanes >= 2;
}

bool LaneAreas::isOncoming(const Pose2& pose) const {
  bool is_in_lane = false;
  for (const Area& area : areas_) {
    if (!isIn(area, pose.position())) continue;
    is_in_lane = true;
    const Pose2 along = lanes_.centerline(area.lane)->project(pose.position()).pose;
    if (std::abs(angleBetween(along.yaw, pose.yaw)) <= kRightAngle) return false;
  }
  return is_in_lane;
}

bool LaneAreas::isIn(const Area& area, const Vector2& point) {
  return area.bounds.contains(point) && contains(area.outline, point);
}

}  // namespace forge
