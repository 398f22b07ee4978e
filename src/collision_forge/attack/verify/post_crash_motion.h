#pragma once

#include <optional>

#include "collision_forge/attack/verify/braking_slide.h"

namespace forge {

/// A vehicle at the instant of a contact.
struct CrashedVehicle {
  AgentClass agent_class = AgentClass::kCar;
  BoxSize size;
  AgentState state;  ///< middle of the box, global map frame
};

/// The motion of the ego and the attacker from their contact on, until both stand: a function of
/// their states at the contact. Bags, pictures, pages, exports and the live display all take the
/// poses after a contact from this class, so a crash ends alike in all of them.
///
/// The rule: both vehicles slide on together, without turning, with the velocity that keeps their
/// common momentum, where the area of a box stands for the mass of its vehicle. They brake as hard
/// as the weaker of the two can. This shows a crash; it is no model of one.
class PostCrashMotion {
 public:
  /// The two states must have the same time, that of the contact.
  PostCrashMotion(const CrashedVehicle& ego, const CrashedVehicle& attacker,
                  const DriveLimitOptions& options);

  /// seconds, same clock as the states
  double contactTime() const { return slide_.begin; }
  /// From then on both stand.
  double standTime() const { return slide_.standTime(); }

  /// The states of the vehicles at `time`; before the contact those at the contact.
  AgentState egoAt(double time) const;
  AgentState attackerAt(double time) const;

 private:
  AgentState stateAfter(const Pose2& contact, double time) const;

  Pose2 ego_;  ///< at the contact, as is the next
  Pose2 attacker_;
  BrakingSlide slide_;
};

/// Returns the motion after a contact at `contact_time`, seconds, where `other` is the vehicle that
/// the ego touches. Empty if one of the two tracks has no state at that time.
std::optional<PostCrashMotion> motionAfterContact(double contact_time, const Track& other,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options);

/// The same where the attacker is that vehicle.
std::optional<PostCrashMotion> motionAfterContact(double contact_time,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options);

/// The same for the contact of a report; also empty if the report has no contact.
std::optional<PostCrashMotion> motionAfterContact(const CollisionReport& report,
                                                  const AttackerTrajectory& trajectory,
                                                  const Track& ego,
                                                  const DriveLimitOptions& options);

}  // namespace forge
