#include "collision_forge/base/geometry/arc_path.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace forge {

double curvatureOf(const ArcPath& path, std::size_t piece) {
  const char letter = path.shape.at(piece);
  switch (letter) {
    case 'L':
      return 1.0 / path.radius;
    case 'S':
      return 0.0;
    case 'R':
      return -1.0 / path.radius;
    default:
      throw std::invalid_argument(std::string("arc path shape '") + letter + "' is not L, S or R");
  }
}

// Uses the circle's chord, which stays exact as the curvature goes to zero.
Pose2 alongArc(const Pose2& pose, double curvature, double arc_length) {
  const double half_turn = 0.5 * curvature * arc_length;
  const double chord = half_turn == 0.0 ? arc_length : arc_length * std::sin(half_turn) / half_turn;
  return {pose.x + chord * std::cos(pose.yaw + half_turn),
          pose.y + chord * std::sin(pose.yaw + half_turn), wrapAngle(pose.yaw + 2.0 * half_turn)};
}

Pose2 poseAt(const ArcPath& path, double arc_length) {
  Pose2 pose = path.start;
  double rest = std::clamp(arc_length, 0.0, path.length());
  for (std::size_t i = 0; i < path.shape.size(); ++i) {
    const double step = std::min(rest, path.segment_length[i]);
    pose = alongArc(pose, curvatureOf(path, i), step);
    rest -= step;
  }
  return pose;
}

std::vector<Pose2> discretize(const std::vector<ArcPath>& paths, double resolution) {
  if (!(resolution > 0.0)) {
    throw std::invalid_argument("arc path resolution must be positive");
  }
  std::vector<Pose2> poses;
  for (const ArcPath& path : paths) {
    const double length = path.length();
    const int count = static_cast<int>(std::max(std::ceil(length / resolution) + 1.5, 2.0));
    for (int i = poses.empty() ? 0 : 1; i < count; ++i) {
      poses.push_back(poseAt(path, length * i / (count - 1)));
    }
  }
  return poses;
}

}  // namespace forge
