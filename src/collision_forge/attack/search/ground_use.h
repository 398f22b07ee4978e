#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// Fast test of the ground under a motion at the nine points samplePointsOf() of the box, for
/// searches. `points` are box centres in the map frame; there must be at least one. Immutable.
class GroundUse {
 public:
  /// `lanes` must outlive this object. offRoadShare() tests every `stride`-th point from the first
  /// on; `stride` must be positive.
  GroundUse(const LaneIndex& lanes, int stride) : lanes_(lanes), stride_(stride) {}

  /// Returns the mean share 0..1 of the box off the drivable area over the tested points up to and
  /// including the first tested one at or after `until` (s, clock of the points); 0 if the map has
  /// no drivable area.
  double offRoadShare(const std::vector<TrajectoryPoint>& points, double until,
                      const BoxSize& size) const;

  /// Returns true if at some point more of the box is on a walkway (and off the road) than at the
  /// first point. False if the map has no walkways.
  bool crossesKerb(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const;

 private:
  const LaneIndex& lanes_;
  int stride_;
};

}  // namespace forge
