#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AttackerTrajectory.h>

#include <optional>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Remembers what the trajectory does not say about an attacker (height, z), and puts it into
/// frames of agents. One that was added is as high, and stands as high, as the nearest recorded
/// vehicle of its class, or of another where there is none.
class AttackerInjector {
 public:
  /// After the end of the trajectory the attacker brakes to a stand (brakingFromEnd()). Throws
  /// MessageError as fromMessage() of the trajectory.
  AttackerInjector(collision_forge::AttackerTrajectory trajectory,
                   const DriveLimitOptions& options);

  /// Drives on by another trajectory of the same vehicle from the same now, and keeps what it
  /// remembers, also of a crash; false, and nothing is changed, where it is of another attack.
  bool change(const collision_forge::AttackerTrajectory& trajectory);

  /// From the contact on the attacker moves as `crash` has it; empty: it has no contact.
  void setCrash(const std::optional<PostCrashMotion>& crash) { crash_ = crash; }

  /// Takes height and z from a recorded frame, if the attacker is in it. inject() does so itself
  /// with frames up to the trajectory's start, and later ones where there was none.
  void remember(const collision_forge::AgentArray& recorded);

  /// Frames up to the trajectory's start pass as they are; an attacker that was added is put into
  /// those of its past, too, as a new agent. Later, the attacker is where its trajectory or its
  /// crash has it, whether it was recorded in that frame or not, and all others are as they were.
  collision_forge::AgentArray inject(collision_forge::AgentArray agents);

 private:
  void rememberLike(const collision_forge::AgentArray& recorded);
  AgentState stateAfterNow(double time) const;
  void put(const AgentState& state, collision_forge::AgentArray& agents) const;

  collision_forge::AttackerTrajectory trajectory_;
  DriveLimitOptions options_;
  std::optional<PostCrashMotion> crash_;
  collision_forge::Agent attacker_;
  bool is_remembered_ = false;
};

}  // namespace forge
