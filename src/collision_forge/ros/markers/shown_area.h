#pragma once

#include <geometry_msgs/PolygonStamped.h>
#include <std_msgs/Header.h>

#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"

/// The part of the map that a top view shows: metres, map frame.
namespace forge {

/// A rectangle along the axes of the map.
struct ShownArea {
  Vector2 lowest{0.0, 0.0};   ///< corner with the smallest x and y
  Vector2 highest{0.0, 0.0};  ///< corner with the largest x and y

  Vector2 middle() const { return (lowest + highest) / 2.0; }
  Vector2 size() const { return highest - lowest; }
};

/// Returns the rectangle around all boxes with a margin of 9 m, and at least `shortest_width`
/// metres wide (along x) and `shortest_width` / 1.4 high (along y). `boxes` must not be empty.
ShownArea areaAround(const std::vector<OrientedBox>& boxes, double shortest_width);

/// Returns the factor for letter heights that keeps texts at the same size on a screen that shows
/// `area`: its width (1.4 times its height if that is more) over kUsualWidth, within [0.6, 3].
double letterScale(const ShownArea& area);

/// Returns the four corners, counterclockwise from `lowest`, as float32, with z 0.
geometry_msgs::PolygonStamped toMessage(const ShownArea& area, const std_msgs::Header& header);

inline constexpr double kUsualWidth = 80.0;  // m, of an area around the ego alone
inline constexpr double kCrashWidth = 50.0;  // m, of an area around a contact

}  // namespace forge
