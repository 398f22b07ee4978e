#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AttackerTrajectory.h>

#include <optional>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Inserts an attacker (or a support vehicle) into frames of agents. The trajectory is planar; the
/// injector takes the z of the box middle, and for an added attacker the height of its box, from
/// recorded frames: a recorded attacker keeps its own, an added one gets them from the recorded
/// vehicle of its class that is nearest to its place at t0, or from the nearest motor vehicle if
/// there is none. Without such a frame z is 0 and the height is size.z of the trajectory. Not
/// thread-safe.
class AttackerInjector {
 public:
  /// `trajectory`: map frame; not checked. After the end of the trajectory the attacker brakes to a
  /// standstill, by the limits `options` (brakingFromEnd()). No frame is remembered yet.
  AttackerInjector(collision_forge::AttackerTrajectory trajectory,
                   const DriveLimitOptions& options);

  /// Replaces the trajectory by a replanned one of the same attack (exactly equal id, class, size,
  /// past and stamp of the header, t0);
  /// height, z and crash are kept. Returns true if it was replaced; returns false and changes
  /// nothing if it belongs to another attack.
  bool change(const collision_forge::AttackerTrajectory& trajectory);

  /// Sets the attacker's motion after the contact; empty: no contact.
  void setCrash(const std::optional<PostCrashMotion>& crash) { crash_ = crash; }

  /// Takes height and z from a recorded frame: of the attacker, which replaces earlier values; for
  /// an added attacker, once, of a similar vehicle. Does nothing if the frame has neither. inject()
  /// calls this for frames up to the trajectory's start (t0), and for later ones until a frame
  /// provided the values.
  void remember(const collision_forge::AgentArray& recorded);

  /// Returns `agents` with the attacker at the time of their stamp. Up to the trajectory's start
  /// (t0, inclusive; always for a trajectory without points), only an added attacker is inserted,
  /// in frames within its past. Later, the attacker has pose and velocity of its trajectory, or
  /// after the contact of its crash, also if it is missing in the recorded frame. Other agents are
  /// unchanged. Throws MessageError like fromMessage() for an invalid trajectory, in frames after
  /// t0.
  collision_forge::AgentArray inject(collision_forge::AgentArray agents);

 private:
  /// Takes height and z for an added attacker from the most similar vehicle of the frame.
  void rememberLike(const collision_forge::AgentArray& recorded);
  /// Returns the attacker's state at `time` (s), which is after t0.
  AgentState stateAfterNow(double time) const;
  /// Replaces the attacker in the frame by one with this state, or adds it.
  void put(const AgentState& state, collision_forge::AgentArray& agents) const;

  collision_forge::AttackerTrajectory trajectory_;
  DriveLimitOptions options_;
  std::optional<PostCrashMotion> crash_;
  collision_forge::Agent attacker_;  // all but x, y, yaw and velocity, which put() sets
  bool is_remembered_ = false;       // height and z of `attacker_` are from a recorded frame
};

}  // namespace forge
