#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "collision_forge/base/geometry/oriented_box.h"
#include "collision_forge/io/drawing/options.h"

namespace forge {

/// The points of a sweep before and after an attack was put into it: m, in base_link (x forward, y
/// left, z up; z = 0 on the ground).
struct CloudPair {
  double time = 0.0;  ///< s
  std::vector<Eigen::Vector3f> recorded, attacked;
};

/// Animates clouds from above, in a loop: the recorded one over the attacked one. Points that only
/// the attacked cloud has are in the attacker's colour, points on the ground are pale. `pairs` must
/// not be empty and be sorted by time; each is shown until the time of the next. `ego`: box of the
/// ego in base_link. Writes to an AsideFile; throws std::runtime_error naming `path` if it cannot
/// be written.
void drawCloudsGif(const std::string& path, const std::vector<CloudPair>& pairs,
                   const OrientedBox& ego, const DrawingOptions& options);

}  // namespace forge
