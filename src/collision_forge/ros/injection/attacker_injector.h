#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AttackerTrajectory.h>

#include <optional>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Inserts an attacker into frames of agents. Takes height and z, which the trajectory lacks, from
/// recorded frames: for a recorded attacker its own, for an added one those from the nearest
/// recorded vehicle of its class, or of any class if there is none. Not thread-safe.
class AttackerInjector {
 public:
  /// After the end of the trajectory the attacker brakes to a standstill, by the limits `options`.
  AttackerInjector(collision_forge::AttackerTrajectory trajectory,
                   const DriveLimitOptions& options);

  /// Replaces the trajectory by a replanned one of the same attack (same vehicle and t0); height, z
  /// and crash are kept. Returns false and changes nothing if it belongs to another attack.
  bool change(const collision_forge::AttackerTrajectory& trajectory);

  /// Sets the attacker's motion after the contact; empty: no contact.
  void setCrash(const std::optional<PostCrashMotion>& crash) { crash_ = crash; }

  /// Takes height and z from a recorded frame, if the attacker is in it. inject() does this for
  /// frames up to the trajectory's start, and for a later frame if there was none before.
  void remember(const collision_forge::AgentArray& recorded);

  /// Returns `agents` with the attacker. Up to the trajectory's start, only an added attacker is
  /// inserted, in the frames of its past. Later, the attacker has the pose of its trajectory or its
  /// crash, also if it is missing in the recorded frame. Other agents are unchanged. Throws
  /// MessageError like fromMessage() of the trajectory, at a time after its end.
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
