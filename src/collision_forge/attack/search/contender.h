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
  const CollisionPattern* pattern = nullptr;  ///< points into SearchInput::patterns
  /// index into SearchInput::egos of the future nearest to the pattern's ego pose at its time
  /// (cornerMiss())
  std::size_t ego = 0;
  /// attacker's box centre in the ego box's frame: the pattern's offset, moved so that the boxes
  /// just touch (touchingOffset())
  Pose2 touching;

  /// Returns how far (m) a corner of a box of size `attacker` is from its place in the pattern, for
  /// a contact that misses it by `miss`, beyond the pattern's tolerance; with `exact`, without
  /// tolerance. At least 0.
  double missedBy(const PatternMiss& miss, const BoxSize& attacker, bool exact) const {
    return std::max(0.0, cornerMiss(miss, attacker) - (exact ? 0.0 : pattern->tolerance));
  }
};

/// A candidate attacker and the motions that it could drive.
struct Contender {
  /// its track in SearchInput::snapshot; for an attacker underway with its state at the snapshot's
  /// t0
  const Track* track = nullptr;
  std::vector<Aim> aims;   ///< its patterns, most promising first; at least one
  DriveStart start;        ///< its motion at t0, and the sampling of its candidates
  DriveLimits limits;      ///< of its class; set only if `driver` is
  DriveState drive_start;  ///< single-track state at t0; set only if `driver` is
  /// drives within `limits`; empty if only the strict limits apply (LimitSet::kStrict, plausibility
  /// not required, not underway)
  std::optional<TrackDriver> driver;
  /// paths that it may follow, in a search by routes (SearchInput::isByRoutes()), else empty; may
  /// be empty there, too, if none comes within kRouteReach of the ego. An attacker underway has the
  /// path of its plan first.
  std::vector<RouteDriver> routes;
  std::unique_ptr<const Conduct> conduct;  ///< of its class, in a search by routes, else null
};

/// Returns the attackers of the patterns, in the order of SearchInput::patterns, most promising
/// first, at most SearchOptions::max_attackers. Leaves out attackers that are not in the snapshot.
/// `limits`: bound on the speed at t0. `points`: number of points of their motions. `input` and
/// `options` must outlive them.
std::vector<std::unique_ptr<Contender>> contendersOf(const SearchInput& input,
                                                     const AttackOptions& options,
                                                     const VehicleLimits& limits, int points);

}  // namespace forge
