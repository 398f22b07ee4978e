#pragma once

#include <optional>
#include <vector>

#include "collision_forge/planner_test/trials/evasive_drives.h"

namespace forge {

/// A motion of the ego without contact: the witness that a crash can be avoided.
struct Avoidance {
  EvasiveManoeuvre manoeuvre = EvasiveManoeuvre::kKeeping;  ///< kind of the motion
  double start = 0.0;  ///< s, scene clock; the ego drives as recorded until then
  /// Path of the middle of the ego's box: a point every AvoidabilityOptions::step from `start` and
  /// one at the end of the attacker's trajectory (kKeeping: at the recorded times); times on the
  /// scene clock
  std::vector<TrajectoryPoint> motion;
  /// Share 0..1 of the box off the drivable area, mean over the motion.
  double off_road_share = 0.0;
};

/// Result of findAvoidability().
struct Avoidability {
  /// Motions that start at t0: the gentlest found of each kind, gentlest kind first. If the
  /// recorded motion has no contact, only this one (kKeeping).
  std::vector<Avoidance> from_now;
  /// The motion with the latest start, out of t0 and every `interval` later before the recorded
  /// ego's contact; nullopt if no motion was found. The crash is avoidable from every earlier
  /// start, too, because the ego can drive as recorded until then.
  std::optional<Avoidance> last;

  /// Returns whether a witness was found. False does not prove that the crash is unavoidable.
  bool isAvoidable() const { return last.has_value(); }
  /// Returns the element of `from_now` of this kind, or null; valid as long as this object is not
  /// changed.
  const Avoidance* find(EvasiveManoeuvre manoeuvre) const;
};

/// Searches for motions of the ego within the strict vehicle limits that have no contact until the
/// end of the attacker's trajectory. The attacker follows its trajectory; other agents drive as
/// recorded. If the ego as recorded (driving straight on at constant speed after the recording's
/// end) has no contact, the result is this motion alone, with kKeeping. A motion has two phases of
/// constant acceleration along the ego's path (routeOf() its recording) or parallel to it, reached
/// by steering as hard as grip and curvature allow. Motions on the road are preferred to gentler
/// ones off it. verifyDrive() checks every witness: continuous contact and every limit. Agents that
/// overlap the ego at t0, except the attacker, are ignored. `route`: of routeOf(). `attack`: limits
/// and tolerances of the verification. Deterministic. Throws as checkScenario() and routeOf().
Avoidability findAvoidability(const CrashScenario& scenario, const AvoidabilityOptions& options,
                              const RouteOptions& route, const AttackOptions& attack);

}  // namespace forge
