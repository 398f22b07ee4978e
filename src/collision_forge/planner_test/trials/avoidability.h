#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/trials/evasive_drives.h"

namespace forge {

/// A motion of the ego that touches nobody: the witness that a crash can be avoided.
struct Avoidance {
  EvasiveManoeuvre manoeuvre = EvasiveManoeuvre::kKeeping;
  double start = 0.0;  ///< s, the scene's clock; until then the ego drives as recorded
  std::vector<TrajectoryPoint> motion;  ///< from `start` to the attacker's end
  double off_road_share = 0.0;          ///< mean share of the box off the drivable area
};

struct Avoidability {
  /// From now on: the gentlest found of each kind, gentlest kind first; at most one with kKeeping.
  std::vector<Avoidance> from_now;
  /// That with the latest start, of now and each `interval` later. It works at every one before,
  /// too: the ego can drive on as recorded until then.
  std::optional<Avoidance> last;

  /// Proven by a witness; otherwise the search found none, which proves nothing.
  bool isAvoidable() const { return last.has_value(); }
  const Avoidance* find(EvasiveManoeuvre manoeuvre) const;
};

/// Looks for motions of the ego within the vehicle limits that touch nobody up to the end of the
/// attacker's trajectory: the attacker drives as it does, the others as recorded. A motion has two
/// stretches of constant acceleration along the ego's way (routeOf() its recording) or a way beside
/// it, which it steers to as hard as grip and curvature allow; motions on the road are preferred.
/// Every witness is verified by verifyDrive(): continuous contact and every limit. Who overlaps
/// the ego already now is not looked at. Deterministic. Throws as checkScenario() and routeOf().
Avoidability findAvoidability(const CrashScenario& scenario, const AvoidabilityOptions& options,
                              const RouteOptions& route, const AttackOptions& attack);

}  // namespace forge
