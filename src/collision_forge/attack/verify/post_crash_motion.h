#pragma once

#include <optional>

#include "collision_forge/attack/severity/severity.h"
#include "collision_forge/attack/verify/braking_slide.h"

namespace forge {

/// Motion of ego and attacker from the contact until both stand, computed from their states at the
/// contact only. Bags, images, pages, exports and the live display all use this class, so a crash
/// ends the same way in all of them.
///
/// Both vehicles move with their common velocity (momentum kept, with the box area as mass),
/// without turning, and decelerate with the lower of their two maximum brakings. This illustrates a
/// crash; it is not a crash model.
class PostCrashMotion {
 public:
  /// Both states must have the contact time.
  PostCrashMotion(const CrashedVehicle& ego, const CrashedVehicle& attacker,
                  const DriveLimitOptions& options);

  /// Returns the contact time, s on the clock of the states.
  double contactTime() const { return braking_.begin; }
  /// Returns the time at which both vehicles stop, s on the same clock.
  double standTime() const { return braking_.standTime(); }

  /// Returns the ego's state at `time` (s); before the contact, its state at the contact.
  AgentState egoAt(double time) const;
  /// As egoAt() for the attacker.
  AgentState attackerAt(double time) const;

 private:
  AgentState stateAfter(const Pose2& contact, double time) const;

  Pose2 ego_;  ///< at the contact, like attacker_
  Pose2 attacker_;
  StraightBraking braking_;
};

/// Returns the motion after a contact of `ego` and `other` at `contact_time` (s); empty if one of
/// the two tracks has no state at that time.
std::optional<PostCrashMotion> motionAfterContact(double contact_time, const Track& other,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options);

/// As above for the attacker of `trajectory`.
std::optional<PostCrashMotion> motionAfterContact(double contact_time,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options);

/// As above for the contact of `report`; empty if the report has no contact.
std::optional<PostCrashMotion> motionAfterContact(const CollisionReport& report,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options);

}  // namespace forge
