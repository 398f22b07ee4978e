#pragma once

#include <array>
#include <vector>

#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// A path of three pieces of constant curvature, as in the `arcline_path_3` table of the nuScenes
/// map expansion. Each letter of `shape` gives a piece's curvature: L +1/radius, S 0, R -1/radius.
/// All poses are in the frame in which `start` is given.
struct ArcPath {
  Pose2 start;                                       ///< pose at arc length 0
  std::array<char, 3> shape = {'L', 'S', 'L'};       ///< one letter per piece, in driving order
  double radius = 1.0;                               ///< metres, > 0
  std::array<double, 3> segment_length = {0, 0, 0};  ///< metres, >= 0, of each piece

  /// Returns the length of the path, m.
  double length() const { return segment_length[0] + segment_length[1] + segment_length[2]; }
};

/// Returns the curvature (1/m, positive to the left) of piece 0, 1 or 2. Throws
/// std::invalid_argument for a letter other than L, S and R, std::out_of_range for another piece.
double curvatureOf(const ArcPath& path, std::size_t piece);

/// Returns the pose `arc_length` (m, negative: before) after `from` on an arc of constant curvature
/// (1/m, positive to the left), exactly; yaw in (-pi, pi].
Pose2 alongArc(const Pose2& from, double curvature, double arc_length);

/// Returns the pose at an arc length (m from the start, clamped to [0, length]), integrated
/// exactly. Throws as curvatureOf().
Pose2 poseAt(const ArcPath& path, double arc_length);

/// Returns the poses of the consecutive paths, joined: n = floor(max(ceil(length / resolution) +
/// 1.5, 2)) evenly spaced poses per path (nuScenes' published discretisation), without the first
/// pose of each later path, which repeats the end of the path before; empty without paths.
/// `resolution` in m. Throws std::invalid_argument if it is not positive.
std::vector<Pose2> discretize(const std::vector<ArcPath>& paths, double resolution);

}  // namespace forge
