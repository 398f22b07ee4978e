#include "collision_forge/base/geometry/touch_point.h"

#include <algorithm>
#include <limits>
#include <vector>

namespace forge {
namespace {

constexpr double kCornerTolerance = 0.05;  // m

}  // namespace

Vector2 touchPoint(const OrientedBox& a, const OrientedBox& b) {
  struct Corner {
    Vector2 position;
    double gap;
  };
  std::vector<Corner> all;
  const auto collect = [&all](const OrientedBox& box, const OrientedBox& other) {
    for (const Vector2& corner : corners(box)) {
      all.push_back({corner, distance({{corner.x(), corner.y(), 0.0}, {}}, other)});
    }
  };
  collect(a, b);
  collect(b, a);
  double smallest = std::numeric_limits<double>::infinity();
  for (const Corner& corner : all) smallest = std::min(smallest, corner.gap);
  Vector2 sum = Vector2::Zero();
  int count = 0;
  for (const Corner& corner : all) {
    if (corner.gap > smallest + kCornerTolerance) continue;
    sum += corner.position;
    ++count;
  }
  return sum / count;
}

}  // namespace forge
