#pragma once

#include "collision_forge/attack/verify/options.h"
#include "collision_forge/attack/verify/verification_input.h"
#include "collision_forge/base/scene/attack.h"

namespace forge {

/// What an attacker did, and from when on it did what ordinary driving along its lane is not.
struct DetectedManoeuvre {
  Manoeuvre manoeuvre = Manoeuvre::kFollowerCloses;
  double begin =
      0.0;  ///< s, the snapshot's clock, from the trajectory's first point to the contact
};

/// Tells the manoeuvre of a trajectory that touches the ego as the report says, whatever made it,
/// from the last kManoeuvreWindow seconds before the contact:
/// - rear_end: who is in front (ego_side); a leader by its speed at the contact and its braking; it
///   begins with that braking, or with the speeds beginning to differ.
/// - lane_change, opposite_direction: by the lane that it was on; it begins where the attacker is
///   last within 0.3 m of the offset that it had from that lane.
/// - junction_crossing, ltap: by how far it turns; it begins at the junction (the first lane marked
///   so) or, where the map has none, with the turn.
DetectedManoeuvre detectManoeuvre(const AttackerTrajectory& trajectory,
                                  const CollisionReport& report, const VerificationInput& input,
                                  const VerificationOptions& options);

inline constexpr double kManoeuvreWindow = 4.0;  // s; a lane change takes 6.3 s in the mean (VTTI)

}  // namespace forge
