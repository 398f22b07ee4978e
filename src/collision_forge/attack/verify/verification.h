#pragma once

#include <optional>

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/attack/verify/verification_input.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The limits that an attacker keeps if it drives by its class.
DriveLimits driveLimitsOf(const Track& attacker, const VerificationOptions& options);

/// How an attacker moves now, as its motion goes on from.
DriveState driveStateNow(const Track& attacker, const VerificationOptions& options);

/// When the attacker first touches who drives `track`, up to `end`, found continuously between
/// samples (see firstContact()); both move linearly between them. Who is not seen is not touched.
std::optional<double> firstContactTime(const AttackerTrajectory& trajectory, const Track& track,
                                       double end, double tolerance);

/// First contact of the attacker with the ego and with anybody else before, found continuously
/// between samples (see firstContact()), and the limits up to it. The ego and the others move
/// linearly between the states of `future`. Whether the contact is as asked is not judged, off-road
/// share and confidence are left at 0. Throws std::invalid_argument for a trajectory without points
/// or a future without an ego.
CollisionReport verifyDrive(const AttackerTrajectory& trajectory, const VerificationInput& input,
                            const VerificationOptions& options);

/// verifyDrive(), and type and time of the contact against the request's CrashDefinition.
CollisionReport verifyMotion(const AttackerTrajectory& trajectory, const VerificationInput& input,
                             const VerificationOptions& options);

/// Mean share of the attacker's box off the drivable area, from now to the report's contact (or to
/// the end), at poses `off_road_interval` apart; 0 when the map has no drivable area.
double offRoadShare(const AttackerTrajectory& trajectory, const CollisionReport& report,
                    const LaneIndex& lanes, const VerificationOptions& options);

/// verifyMotion() and offRoadShare(); of a contact also the manoeuvre (detectManoeuvre()) and
/// whether a driver could do it (whyUnbelievable()), which is no condition of verified().
CollisionReport verify(const AttackerTrajectory& trajectory, const VerificationInput& input,
                       const VerificationOptions& options);

}  // namespace forge
