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

/// A pattern that is aimed at.
struct Aim {
  const CollisionPattern* pattern = nullptr;
  std::size_t ego = 0;  ///< the future whose pose at the pattern's time is nearest to its ego's box
  Pose2 touching;       ///< the pattern's offset, moved so that the boxes just touch

  /// How far a corner of the attacker is from the pattern beyond what the pattern allows for, m;
  /// `exact`: it allows for nothing.
  double missedBy(const PatternMiss& miss, const BoxSize& attacker, bool exact) const {
    return std::max(0.0, cornerMiss(miss, attacker) - (exact ? 0.0 : pattern->tolerance));
  }
};

/// One vehicle that may attack, and the ways it may drive.
struct Contender {
  const Track* track = nullptr;
  std::vector<Aim> aims;  ///< its patterns, the most promising first
  DriveStart start;
  DriveLimits limits;      ///< of its class
  DriveState drive_start;  ///< the same as a single track, where it drives by its class
  /// Within the limits of its class; empty where any motion within the strict limits will do.
  std::optional<TrackDriver> driver;
  std::vector<RouteDriver>
      routes;  ///< with SearchedMotion::kByRoutes: the paths that it may follow
};

/// The vehicles of the patterns, the most promising first and at most SearchOptions::max_attackers.
/// `points` are asked of their motions. Snapshot and patterns must outlive them.
std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points);

}  // namespace forge
