#pragma once

#include <optional>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/attack/verify/verification.h"

namespace forge {

/// Finds the contact of an attack with a live ego, whose poses arrive one after the other, and
/// derives the motion after the contact. The contact is found as in verify(). Not thread-safe.
class ContactWatch {
 public:
  /// `kept_for`: seconds of the ego's poses that are kept, because an attack may be started later
  /// than its now.
  ContactWatch(const BoxSize& ego_size, double kept_for, const VerificationOptions& options);

  /// Watches an attack in place of the one before, from the poses that are kept on. `trajectory`
  /// must have points.
  void start(AttackerTrajectory trajectory);
  /// Sets a new plan of the attacker that is watched. A contact that was found remains.
  void change(AttackerTrajectory trajectory);
  void stop();

  /// Sets the size of the ego's box for all later poses, m.
  void setEgoSize(const BoxSize& size) { ego_.size = size; }

  /// Middle of the ego's box; the velocity is derived from the poses. A pose that is not later than
  /// the one before is from a replay that went back; to before the contact, the contact is
  /// forgotten.
  void addEgo(const AgentState& ego);

  /// The poses that are kept, with their velocities.
  const Track& ego() const { return ego_; }
  /// Set from the pose on that is the first after the contact. The next pose completes the ego's
  /// velocity at the contact.
  const std::optional<PostCrashMotion>& crash() const { return crash_; }
  /// The crash whose contact lies between the last pose and `ego`, a prediction of the next one.
  /// Empty where a crash was found already.
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
  AttackerTrajectory crashed_;     // the same as it was at the contact
  std::optional<PostCrashMotion> crash_;
  bool is_complete_ = false;  // the ego's velocity at the contact does not depend on later poses
};

}  // namespace forge
