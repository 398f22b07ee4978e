#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// Finds the ways that lead to a place on a lane. `lanes` must outlive it.
class LaneWays {
 public:
  explicit LaneWays(const LaneIndex& lanes);

  /// The ways along centrelines to the place at an arc length of a lane, from `back` metres before
  /// it or where the lanes begin, and `ahead` metres on along straightestSuccessor(). At most
  /// `most`: first the one that takes the straightest lane at each fork backwards, then those that
  /// leave it, nearest first, then those that leave these. Throws std::invalid_argument for a lane
  /// without a centreline.
  std::vector<Polyline> to(std::size_t lane, double arc_length, double back, double ahead,
                           std::size_t most) const;

 private:
  std::vector<std::size_t> before(std::size_t lane) const;

  const LaneIndex& lanes_;
  std::vector<std::vector<std::size_t>> predecessors_;  // one a lane
};

}  // namespace forge
