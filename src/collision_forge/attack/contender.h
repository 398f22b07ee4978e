#pragma once

#include <memory>
#include <vector>

#include "collision_forge/attack/attack_search.h"
#include "collision_forge/attack/trajectory_family.h"
#include "collision_forge/map/reference_path.h"

namespace forge {

/// One vehicle that may attack, and the ways it may drive.
struct Contender {
  const Track* track = nullptr;
  DriveStart start;
  std::vector<ReferencePath> paths;                         ///< along lanes
  std::vector<std::unique_ptr<TrajectoryFamily>> quintics;  ///< free, then one a path
};

/// The vehicles of the patterns, the most promising first and at most SearchOptions::max_attackers.
/// `points` are asked of their motions. The snapshot must outlive them.
std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points);

}  // namespace forge
