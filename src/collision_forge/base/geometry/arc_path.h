#pragma once

#include <array>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Three pieces of constant curvature, as in the `arcline_path_3` table of the nuScenes map
/// expansion: the letters of `shape` give each piece's curvature, +1/radius (L), 0 (S), -1/radius
/// (R).
struct ArcPath {
  Pose2 start;
  std::array<char, 3> shape = {'L', 'S', 'L'};
  double radius = 1.0;                               ///< metres, > 0
  std::array<double, 3> segment_length = {0, 0, 0};  ///< metres, >= 0

  double length() const { return segment_length[0] + segment_length[1] + segment_length[2]; }
};

/// Of piece 0, 1 or 2, 1/m, positive to the left. Throws std::invalid_argument for a letter that is
/// none of L, S and R.
double curvatureOf(const ArcPath& path, std::size_t piece);

/// The pose an arc length (m) further along a constant curvature (1/m), exactly.
Pose2 alongArc(const Pose2& from, double curvature, double arc_length);

/// Pose at an arc length in [0, length], integrated exactly.
Pose2 poseAt(const ArcPath& path, double arc_length);

/// n = max(ceil(length / resolution) + 1.5, 2) evenly spaced poses of each path in turn (the
/// published discretisation), the repeated pose at each joint dropped. Metres.
std::vector<Pose2> discretize(const std::vector<ArcPath>& paths, double resolution);

}  // namespace forge
