#pragma once

#include <vector>

#include "collision_forge/io/export/lane_bundles.h"

namespace forge {

/// Borders of a bundle's lanes at arc lengths of its course.
struct BundleProfile {
  std::vector<double> arc_lengths;  ///< m, ascending, from `begin` to `end`
  /// m from the course, positive to the left: for each element of `arc_lengths`, the left and the
  /// right border of each member, in the order of LaneBundle::members (2 x members values). The
  /// middle of both is the lane's centreline. Borders of neighbours are equal or leave a gap.
  std::vector<std::vector<double>> borders;
};

inline constexpr double kProfileTolerance = 0.01;  ///< m, between centrelines and the profile
/// Returns the borders of a bundle at few arc lengths from begin to end; linear interpolation in
/// between is right within kProfileTolerance. `lanes` as for bundlesOf().
BundleProfile profileOf(const LaneBundle& bundle, const std::vector<BundleLane>& lanes);

}  // namespace forge
