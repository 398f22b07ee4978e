#pragma once

#include <optional>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {

/// Finds the contact of an attack with a live ego whose poses arrive one by one, with the contact
/// test of verify(), and derives the post-crash motion. Not thread-safe.
class ContactWatch {
 public:
  /// `ego_size`: size of the ego's box. `kept_for` (s): age, relative to the newest ego pose, up to
  /// which ego poses are kept, because an attack may arrive later than its t0. The fields
  /// overlap_tolerance and severity of `options` are used. No attack is watched before start().
  ContactWatch(const BoxSize& ego_size, double kept_for, const VerificationOptions& options);

  /// Replaces the watched attack, forgets an earlier crash and tests the kept ego poses against the
  /// new attack, so crash() may be set at once. `trajectory` must have points.
  void start(AttackerTrajectory trajectory);
  /// Replaces the trajectory of the watched attack, for example after a replan; a crash already
  /// found remains. The new trajectory is tested from the next ego pose on.
  void change(AttackerTrajectory trajectory);
  /// Ends the watch and forgets the crash; the ego poses are kept. start() may follow.
  void stop();

  /// Sets the size of the ego's box for all later poses, m.
  void setEgoSize(const BoxSize& size) { ego_.size = size; }

  /// Adds an ego state; its pose is the box centre, global map frame. Its velocity is ignored and
  /// derived from the poses. A time not later than the previous one means that a replay went back:
  /// the poses are cleared, and the crash too if its contact is later than `ego`; the attack stays
  /// watched. A contact counts only after the first point of the trajectory.
  void addEgo(const AgentState& ego);

  /// Returns the kept ego poses, oldest first, with derived velocities.
  const Track& ego() const { return ego_; }
  /// Returns the crash, set by the first addEgo() at or after the contact, or by start(); empty if
  /// there is none so far. The next pose completes the ego's velocity at the contact, so the motion
  /// may change once. The reference is valid as long as this object; its content changes with the
  /// next call of a non-const function.
  const std::optional<PostCrashMotion>& crash() const { return crash_; }
  /// Returns the crash whose contact lies between the newest pose and `ego`, a predicted next
  /// state; empty if there is none or a crash was found already.
  std::optional<PostCrashMotion> crashBefore(const AgentState& ego) const;

 private:
  std::optional<double> contactWith(const Track& ego) const;
  void find(const Track& ego);
  void setCrash(double contact_time);
  Track between(const AgentState& from, const AgentState& to) const;

  VerificationOptions options_;
  double kept_for_;  // s
  Track ego_;
  AttackerTrajectory trajectory_;  // without points: no attack
  AttackerTrajectory crashed_;     // `trajectory_` at the contact
  std::optional<PostCrashMotion> crash_;
  bool is_complete_ = false;  // later poses do not change the ego's velocity at the contact
};

}  // namespace forge
