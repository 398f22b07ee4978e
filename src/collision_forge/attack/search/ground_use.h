#pragma once

#include <vector>

#include "collision_forge/base/map/lane_queries.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// What ground a motion uses, told by nine places of the box: quick, for searches. Immutable.
class GroundUse {
 public:
  /// `lanes` must outlive it. `stride`: points from one that offRoadShare() looks at to the next.
  GroundUse(const LaneIndex& lanes, int stride) : lanes_(lanes), stride_(stride) {}

  /// Mean share of the box off the drivable area at the points up to and including the first at or
  /// after `until`; 0 when the map has none.
  double offRoadShare(const std::vector<TrajectoryPoint>& points, double until,
                      const BoxSize& size) const;

  /// True when more of the box comes to be on a walkway (and on no road) than is at the first
  /// point.
  bool crossesKerb(const std::vector<TrajectoryPoint>& points, const BoxSize& size) const;

 private:
  const LaneIndex& lanes_;
  int stride_;
};

}  // namespace forge
