#pragma once

#include <vector>

#include "collision_forge/io/export/lane_bundles.h"

namespace forge {

/// Borders of a bundle's lanes at arc lengths of its course.
struct BundleProfile {
  std::vector<double> arc_lengths;  ///< m, ascending, from `begin` to `end`
  /// m from the course, positive to the left: per arc length, the left and the right border of each
  /// member. The middle of both is the lane's centreline. Borders of neighbours are equal or leave
  /// a gap.
  std::vector<std::vector<double>> borders;
};

inline constexpr double kProfileTolerance = 0.01;  ///< m, between centrelines and the profile
/// Returns the borders of a bundle, at few arc lengths: linear in between within
/// kProfileTolerance. `lanes` as for bundlesOf().
BundleProfile profileOf(const LaneBundle& bundle, const std::vector<BundleLane>& lanes);

}  // namespace forge
