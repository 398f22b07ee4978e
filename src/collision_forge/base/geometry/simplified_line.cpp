#include "collision_forge/base/geometry/simplified_line.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>

namespace forge {

std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance) {
  namespace bg = boost::geometry;
  using Point = bg::model::d2::point_xy<double>;
  const auto is_finite = [](const Vector2& point) { return point.allFinite(); };
  if (line.size() < 3 || !std::all_of(line.begin(), line.end(), is_finite)) return line;
  bg::model::linestring<Point> all;
  bg::model::linestring<Point> kept;
  for (const Vector2& point : line) all.emplace_back(point.x(), point.y());
  bg::simplify(all, kept, tolerance);
  std::vector<Vector2> points;
  for (const Point& point : kept) points.emplace_back(point.x(), point.y());
  return points;
}

}  // namespace forge
