#include "collision_forge/report/map_lines.h"

#include <algorithm>
#include <utility>

namespace forge {
namespace {

double distanceToSegment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 along = b - a;
  const double length = along.squaredNorm();
  const double ratio = length > 0.0 ? (point - a).dot(along) / length : 0.0;
  return (point - a - std::clamp(ratio, 0.0, 1.0) * along).norm();
}

/// Keeps what is inside one border of the box: `axis` is 0 for x, `sign` 1 where inside is below.
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

std::vector<Vector2> simplified(const std::vector<Vector2>& line, double tolerance) {
  if (line.size() < 3) return line;
  std::vector<bool> is_kept(line.size(), false);
  is_kept.front() = is_kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> stretches = {{0, line.size() - 1}};
  while (!stretches.empty()) {
    const auto [first, last] = stretches.back();
    stretches.pop_back();
    double farthest = tolerance;
    std::size_t split = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distanceToSegment(line[i], line[first], line[last]);
      if (distance <= farthest) continue;
      farthest = distance;
      split = i;
    }
    if (split == first) continue;
    is_kept[split] = true;
    stretches.emplace_back(first, split);
    stretches.emplace_back(split, last);
  }
  std::vector<Vector2> kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (is_kept[i]) kept.push_back(line[i]);
  }
  return kept;
}

std::vector<Vector2> clippedRing(std::vector<Vector2> ring, const Eigen::AlignedBox2d& box) {
  for (const int axis : {0, 1}) {
    ring = clippedSide(ring, axis, box.max()[axis], 1.0);
    ring = clippedSide(ring, axis, box.min()[axis], -1.0);
  }
  return ring;
}

}  // namespace forge
