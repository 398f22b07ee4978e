#include "collision_forge/planner_test/planners/box_circles.h"

#include <algorithm>
#include <cmath>

namespace forge {

BoxCircles circlesOf(const BoxSize& size) {
  const double shorter = std::min(size.length, size.width);
  const double radius = 0.25 * shorter;
  const double along = 0.5 * size.length - radius;
  const double across = 0.5 * size.width - radius;
  BoxCircles circles;
  circles.corners = {Vector2{along, across}, Vector2{along, -across}, Vector2{-along, across},
                     Vector2{-along, -across}};
  circles.corner_radius = radius;
  circles.middle_radius = 0.5 * shorter;
  circles.reach = std::max(std::hypot(along, across) + radius, circles.middle_radius);
  return circles;
}

PlacedCircles placed(const BoxCircles& circles, const Vector2& middle, const Vector2& heading) {
  PlacedCircles there;
  there.middle = middle;
  for (std::size_t i = 0; i < circles.corners.size(); ++i) {
    const Vector2& corner = circles.corners[i];
    there.corners[i] = {middle.x() + corner.x() * heading.x() - corner.y() * heading.y(),
                        middle.y() + corner.x() * heading.y() + corner.y() * heading.x()};
  }
  return there;
}

double gapBetween(const BoxCircles& a, const PlacedCircles& a_there, const BoxCircles& b,
                  const PlacedCircles& b_there) {
  // Compares squared distances of circles with the same radii, so that each pair of radii needs one
  // square root.
  double corners = (a_there.corners[0] - b_there.corners[0]).squaredNorm();
  double a_corner = (a_there.corners[0] - b_there.middle).squaredNorm();
  double b_corner = (b_there.corners[0] - a_there.middle).squaredNorm();
  for (const Vector2& from : a_there.corners) {
    a_corner = std::min(a_corner, (from - b_there.middle).squaredNorm());
    for (const Vector2& to : b_there.corners) {
      corners = std::min(corners, (from - to).squaredNorm());
    }
  }
  for (const Vector2& from : b_there.corners) {
    b_corner = std::min(b_corner, (from - a_there.middle).squaredNorm());
  }
  const double middles = (a_there.middle - b_there.middle).norm();
  return std::min({std::sqrt(corners) - a.corner_radius - b.corner_radius,
                   std::sqrt(a_corner) - a.corner_radius - b.middle_radius,
                   std::sqrt(b_corner) - a.middle_radius - b.corner_radius,
                   middles - a.middle_radius - b.middle_radius});
}

}  // namespace forge
