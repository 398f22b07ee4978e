#include "collision_forge/planner_test/report/map_lines.h"

namespace forge {
namespace {

/// Clips at one border of the box: `axis` is 0 for x; `sign` is 1 if the inside is below it.
std::vector<Vector2> clippedSide(const std::vector<Vector2>& ring, int axis, double border,
                                 double sign) {
  const auto outside = [&](const Vector2& point) { return sign * (point[axis] - border); };
  std::vector<Vector2> kept;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector2& from = ring[i];
    const Vector2& to = ring[(i + 1) % ring.size()];
    const double before = outside(from);
    const double after = outside(to);
    if (before <= 0.0) kept.push_back(from);
    if ((before < 0.0 && after > 0.0) || (before > 0.0 && after < 0.0)) {
      kept.push_back(from + before / (before - after) * (to - from));
    }
  }
  return kept;
}

}  // namespace

std::vector<Vector2> clippedRing(std::vector<Vector2> ring, const Eigen::AlignedBox2d& box) {
  for (const int axis : {0, 1}) {
    ring = clippedSide(ring, axis, box.max()[axis], 1.0);
    ring = clippedSide(ring, axis, box.min()[axis], -1.0);
  }
  return ring;
}

}  // namespace forge
