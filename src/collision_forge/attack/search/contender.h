#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/attack/search/trajectory_family.h"

namespace forge {

/// A target of the search: one collision pattern.
struct Aim {
  const CollisionPattern* pattern = nullptr;
  std::size_t ego = 0;  ///< index of the future nearest to the pattern's ego pose at its time
  Pose2 touching;       ///< touchingOffset() of the pattern's attacker_offset

  /// Returns how far (m) a corner of the attacker is from the pattern beyond the pattern's
  /// tolerance; with `exact`, without tolerance.
  double missedBy(const PatternMiss& miss, const BoxSize& attacker, bool exact) const {
    return std::max(0.0, cornerMiss(miss, attacker) - (exact ? 0.0 : pattern->tolerance));
  }
};

/// A candidate attacker and the motions that it could drive.
struct Contender {
  const Track* track = nullptr;  ///< in the snapshot
  std::vector<Aim> aims;         ///< its patterns, most promising first
  DriveStart start;
  // Set if the limits of the class apply (kDrivable, plausible or underway); not with the strict
  // limits alone:
  DriveLimits limits;
  DriveState drive_start;  ///< single-track state at t0
  std::optional<TrackDriver> driver;
  std::vector<RouteDriver> routes;  ///< paths that it may follow, in a search by routes
};

/// Returns the attackers of the patterns, most promising first, up to the configured maximum.
/// `points`: number of points of their motions. `input` and `options` must outlive them.
std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points);

}  // namespace forge
