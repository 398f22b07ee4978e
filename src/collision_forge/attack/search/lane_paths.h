#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/base/map/lane_queries.h"

namespace forge {

/// Finds paths along lanes that lead to a place. Immutable.
class LanePaths {
 public:
  /// Finds the predecessors of all lanes. Keeps a reference to `lanes`, which must outlive this
  /// object.
  explicit LanePaths(const LaneIndex& lanes);

  /// Returns paths (map frame) along centrelines to the place at `arc_length` (m from its start) of
  /// `lane` (index into LaneMap::lanes), starting `back` m before it or where the lanes begin, and
  /// continuing `ahead` m along straightestSuccessor() or until the lanes end. At least one and at
  /// most `most` paths: first the one that takes the straightest predecessor (least change of
  /// heading along it) at each fork, then paths that branch off it, nearest first, then branches of
  /// these. Throws std::invalid_argument for a lane without a centreline.
  std::vector<Polyline> to(std::size_t lane, double arc_length, double back, double ahead,
                           std::size_t most) const;

 private:
  std::vector<std::size_t> before(std::size_t lane) const;

  const LaneIndex& lanes_;
  std::vector<std::vector<std::size_t>> predecessors_;  // [lane]
};

}  // namespace forge
