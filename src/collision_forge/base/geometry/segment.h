#pragma once

#include <algorithm>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Returns the point of the segment closest to `point`, as a share in [0, 1] of the way from `from`
/// to `to`; 0 for a segment of length 0.
inline double nearestShare(const Vector2& from, const Vector2& to, const Vector2& point) {
  const Vector2 span = to - from;
  const double squared = span.squaredNorm();
  return squared > 0.0 ? std::clamp((point - from).dot(span) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace forge
