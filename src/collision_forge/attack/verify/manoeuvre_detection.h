#pragma once

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/attack/verify/verification_input.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// An attacker's manoeuvre and the time at which it departs from normal lane following.
struct DetectedManoeuvre {
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;
  /// s, scene clock, between the trajectory's first point and the contact
  double begin = 0.0;
};

/// Classifies the manoeuvre of a trajectory that touches the ego, from the last kManoeuvreWindow
/// seconds before the contact, by the requested type:
/// - rear_end: an attacker that touches the ego's front leads, any other follows; a leader is
///   stopped (below 0.5 m/s), braking (above 1 m/s2) or slow. Starts with the braking, or when the
///   speeds begin to differ.
/// - lane_change, opposite_direction, sideswipe_same_direction: from the attacker's lane at the
///   start of the window; without a lane there, pull_out (if the attacker stands) or cut_in, for
///   opposite_direction wrong_way or centre_line_crossing, from the window's start. Starts where
///   the attacker last was within 0.3 m of its original offset from that lane.
/// - junction_crossing, any: a vehicle that moves backwards at the contact backs out, from the
/// start
///   of that motion on; a turn above 0.5 rad in the window turns into the path, else the
///   attacker crosses straight. ltap: by CollisionRequest::turning. Starts at the first point on a
///   junction lane or, if the map marks none at the contact, with the turn.
/// - angle types: by the path along the attacker's lane at the start of the window: a crossing, a
///   turn off an oncoming path or off a path in the ego's direction, or a departure from it.
///
/// `report` needs the contact, its time, the touched side of the ego and the ego's pose at contact;
/// `report.contact` must be true. `input.snapshot` is not used, of `options` only `believability`.
/// The attacker may be recorded or added.
DetectedManoeuvre detectManoeuvre(const AttackerTrajectory& trajectory,
                                  const CollisionReport& report, const VerificationInput& input,
                                  const VerificationOptions& options);

/// s before the contact; the mean lane change takes 6.3 s (VTTI)
inline constexpr double kManoeuvreWindow = 4.0;

}  // namespace forge
