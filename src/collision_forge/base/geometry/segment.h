#pragma once

#include <algorithm>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// The place on the straight piece between two points that is nearest to another, as a share of the
/// piece from `from` on, in [0, 1]; 0 on a piece without length.
inline double nearestShare(const Vector2& from, const Vector2& to, const Vector2& point) {
  const Vector2 span = to - from;
  const double squared = span.squaredNorm();
  return squared > 0.0 ? std::clamp((point - from).dot(span) / squared, 0.0, 1.0) : 0.0;
}

}  // namespace forge
