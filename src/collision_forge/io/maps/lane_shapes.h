#pragma once

#include <vector>

#include "collision_forge/base/map/lane_map.h"

namespace forge {

/// Suffix of the id of a lane against the direction of its lanelet.
inline constexpr char kReverse[] = ":reverse";

/// The two sides of a lane, in driving direction. Metres, map frame; two or more points each.
struct LaneBounds {
  std::vector<Vector2> left;
  std::vector<Vector2> right;
};

/// Returns the line midway between two bounds: the middles of connections between their points,
/// each as short as possible, from the first points to the last (as the centreline of
/// lanelet2_core); one point fewer than both bounds have together. Both bounds must have a point.
std::vector<Vector2> middleOf(const LaneBounds& bounds);

/// Returns the poses at the points of a line (m), and between them at most `spacing` (m, > 0)
/// apart, with the yaw along the line; points within 1 cm of the kept point before are left out,
/// but the last pose is at the last point of the line if more than two points are kept. Returns no
/// pose for a line without two points more than 1 cm apart, and for a line that would have
/// more than `max_poses` poses.
std::vector<Pose2> posesAlong(const std::vector<Vector2>& line, double spacing, int max_poses);

/// Returns the outline of the area between the bounds as an open ring: the left bound, then the
/// right bound backwards.
std::vector<Vector2> outlineOf(const LaneBounds& bounds);

/// Returns the bounds of the opposite driving direction: both reversed and exchanged.
LaneBounds reversedBounds(const LaneBounds& bounds);

}  // namespace forge
