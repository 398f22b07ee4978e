#pragma once

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/attack/search/conduct.h"
#include "collision_forge/attack/search/route_driver.h"
#include "collision_forge/attack/search/search_task.h"
#include "collision_forge/attack/search/track_driver.h"
#include "collision_forge/attack/search/trajectory_family.h"

namespace forge {

/// A target of the search: one collision pattern.
struct Aim {
  const CollisionPattern* pattern = nullptr;
  std::size_t ego = 0;  ///< index of the future nearest to the pattern's ego pose
  Pose2 touching;       ///< the pattern's offset, moved so that the boxes just touch

  /// Returns how far (m) a corner of the attacker is from the pattern beyond the pattern's
  /// tolerance; with `exact`, without tolerance.
  double missedBy(const PatternMiss& miss, const BoxSize& attacker, bool exact) const {
    return std::max(0.0, cornerMiss(miss, attacker) - (exact ? 0.0 : pattern->tolerance));
  }
};

/// A candidate attacker and the motions that it could drive.
struct Contender {
  const Track* track = nullptr;
  std::vector<Aim> aims;   ///< its patterns, most promising first
  DriveStart start;        ///< its motion at t0, and the sampling of its candidates
  DriveLimits limits;      ///< of its class; unset without `driver`
  DriveState drive_start;  ///< single-track state at t0; unset without `driver`
  std::optional<TrackDriver>
      driver;  ///< drives within `limits`; empty if only the strict limits apply
  std::vector<RouteDriver> routes;         ///< paths that it may follow, in a search by routes
  std::unique_ptr<const Conduct> conduct;  ///< of its class, in a search by routes
};

/// Returns the attackers of the patterns, most promising first, up to the configured maximum.
/// `points`: number of points of their motions. `input` and `options` must outlive them.
std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points);

}  // namespace forge
