#pragma once

#include <optional>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/attack/verify/verification_input.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Returns the limits of `attacker` under LimitSet::kDrivable.
DriveLimits driveLimitsOf(const Track& attacker, const VerificationOptions& options);

/// Returns the attacker's state at the last state of `attacker`, its track up to t0, from which its
/// trajectory continues; see estimateMotion(). Throws std::invalid_argument if the track has no
/// states.
DriveState driveStateNow(const Track& attacker, const VerificationOptions& options);

/// Returns the time (s, scene clock) of the first contact of the attacker with the agent of `track`
/// from the trajectory's first point up to `end` (s); empty if there is none. If the boxes overlap
/// at the first point, that is the contact. Continuous between samples (see firstContact(),
/// `tolerance` in m); both vehicles move linearly between samples. Gaps of the track are skipped; a
/// track without states has no contact. `trajectory` must have points.
std::optional<double> firstContactTime(const AttackerTrajectory& trajectory, const Track& track,
                                       double end, double tolerance);

/// Finds the attacker's first contact with the ego and any earlier contact with another agent, and
/// checks the vehicle limits up to it; without a contact, up to the trajectory's last point. A
/// requested Manoeuvre::kBackOut is checked in the direction of travel (reversingLimits()). If ego
/// and attacker overlap at the first point, the report has no contact. Agents move linearly between
/// the states of `input.future`. Leaves type_kept, on_time, the severity, road use, manoeuvre,
/// off_road_share and confidence at their defaults. Throws std::invalid_argument if the trajectory
/// has no points or `input.future.ego` no states.
CollisionReport verifyDrive(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const VerificationOptions& options);

/// verifyDrive(), then sets type_kept and on_time by the request's CrashDefinition if there is a
/// contact. Throws as verifyDrive() and, if there is a contact, as request.bands().
CollisionReport verifyMotion(const AttackerTrajectory& trajectory, const VerificationInput& input,
                             const VerificationOptions& options);

/// Returns the mean share 0..1 of the attacker's box off the drivable area from t0 to the report's
/// contact (without a contact, to the trajectory's end), sampled every options.off_road_interval; 0
/// if the map has no drivable area.
double offRoadShare(const AttackerTrajectory& trajectory, const CollisionReport& report,
                    const LaneIndex& lanes, const VerificationOptions& options);

/// verifyMotion() and offRoadShare(); if there is a contact, also the severity (severityOf()), the
/// manoeuvre (detectManoeuvre()), and the road use and plausibility (roadUseOfAttack(),
/// implausibilityOf(), for people on foot implausibleWalk(), for a requested Manoeuvre::kBackOut
/// implausibleReversing()), which verified() does not include.
/// Leaves confidence and careful_drivers at their defaults. Throws as verifyMotion() and
/// severityOf().
CollisionReport verify(const AttackerTrajectory& trajectory, const VerificationInput& input,
                       const VerificationOptions& options);

}  // namespace forge
