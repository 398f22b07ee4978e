#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AttackerTrajectory.h>

#include <optional>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Puts the attacker into frames of agents, with height and z from recorded frames, since the
/// trajectory has neither. An added attacker gets height and z of the nearest recorded vehicle of
/// its class, or of any class if there is none.
class AttackerInjector {
 public:
  /// After the end of the trajectory the attacker brakes to a stand (slideFromEnd()). Throws
  /// MessageError as fromMessage() of the trajectory.
  AttackerInjector(collision_forge::AttackerTrajectory trajectory,
                   const DriveLimitOptions& options);

  /// Replaces the trajectory by another one of the same vehicle and t0; keeps height, z and crash.
  /// Returns false and changes nothing if the trajectory belongs to another attack.
  bool change(const collision_forge::AttackerTrajectory& trajectory);

  /// Sets the attacker's motion from the contact on; empty: no contact.
  void setCrash(const std::optional<PostCrashMotion>& crash) { crash_ = crash; }

  /// Takes height and z from a recorded frame, if the attacker is in it. inject() does so itself
  /// with frames up to the trajectory's start, and later ones where there was none.
  void remember(const collision_forge::AgentArray& recorded);

  /// Frames up to the trajectory's start pass as they are; an attacker that was added is put into
  /// those of its past, too, as a new agent. Later, the attacker is where its trajectory or its
  /// crash has it, recorded in that frame or not; other agents stay unchanged.
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
