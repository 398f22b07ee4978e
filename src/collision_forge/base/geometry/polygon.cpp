#include "collision_forge/base/geometry/polygon.h"

#include <algorithm>

namespace forge {
namespace {

// Even-odd rule: counts the edges that a ray from the point towards +x crosses.
bool ringContains(const std::vector<Vector2>& ring, const Vector2& point) {
  bool inside = false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& a = ring[i];
    const Vector2& b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if ((a.y() > point.y()) == (b.y() > point.y())) {
      continue;
    }
    const double ratio = (point.y() - a.y()) / (b.y() - a.y());
    if (point.x() < a.x() + ratio * (b.x() - a.x())) {
      inside = !inside;
    }
  }
  return inside;
}

}  // namespace

bool contains(const Polygon& polygon, const Vector2& point) {
  return ringContains(polygon.exterior, point) &&
         std::none_of(polygon.holes.begin(), polygon.holes.end(),
                      [&](const auto& hole) { return ringContains(hole, point); });
}

std::vector<Vector2> stripAlong(const std::vector<Pose2>& line, double width) {
  std::vector<Vector2> outline;
  for (const Pose2& pose : line) {
    outline.push_back(compose(pose, {0.0, 0.5 * width, 0.0}).position());
  }
  for (auto pose = line.rbegin(); pose != line.rend(); ++pose) {
    outline.push_back(compose(*pose, {0.0, -0.5 * width, 0.0}).position());
  }
  return outline;
}

}  // namespace forge
