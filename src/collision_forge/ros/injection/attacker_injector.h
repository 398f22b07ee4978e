#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/AttackerTrajectory.h>

#include <optional>

#include "collision_forge/attack/verify/drive_limits.h"
#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/geometry/pose2.h"

namespace forge {

/// Behaviour of a vehicle after the last point of its trajectory.
enum class AfterEnd {
  kBrake,  ///< brakes to a standstill (brakingFromEnd()), as attackers
  kLeave   ///< leaves the scene unless it stands there, as support vehicles
};

/// Inserts an attacker (or a support vehicle) into frames of agents, with the class of its
/// trajectory. The trajectory is planar; a recorded attacker keeps the height and the z of its
/// recorded box. An added one has the typical height of its class and stands on the ground of the
/// recorded motor vehicle, or agent of its class, that is nearest to its place at t0. Without such
/// a frame z is 0 and the height is size.z of the trajectory. Not thread-safe.
class AttackerInjector {
 public:
  /// `trajectory`: map frame; not checked. `options`: limits of the braking after its end. No frame
  /// is remembered yet.
  AttackerInjector(collision_forge::AttackerTrajectory trajectory, const DriveLimitOptions& options,
                   AfterEnd after_end = AfterEnd::kBrake);

  /// Replaces the trajectory by a replanned one of the same attack (exactly equal id, class, size,
  /// past and stamp of the header, t0);
  /// height, z and crash are kept. Returns true if it was replaced; returns false and changes
  /// nothing if it belongs to another attack.
  bool change(const collision_forge::AttackerTrajectory& trajectory);

  /// Sets the attacker's motion after the contact; empty: no contact.
  void setCrash(const std::optional<PostCrashMotion>& crash) { crash_ = crash; }

  /// Takes height and z from a recorded frame: of the attacker, which replaces earlier values; for
  /// an added attacker, once, z from the nearest vehicle. Does nothing if the frame has neither.
  /// inject() calls this for frames up to the trajectory's start (t0), and for later ones until a
  /// frame provided the values.
  void remember(const collision_forge::AgentArray& recorded);

  /// Returns `agents` with the attacker at the time of their stamp. Up to the trajectory's start
  /// (t0, inclusive; always for a trajectory without points), only an added attacker is inserted,
  /// in frames within its past. Later, the attacker has pose and velocity of its trajectory, or
  /// after the contact of its crash, also if it is missing in the recorded frame; one that has left
  /// (AfterEnd::kLeave) is in no frame. Other agents are unchanged. Throws MessageError like
  /// fromMessage() for an invalid trajectory, in frames after t0.
  collision_forge::AgentArray inject(collision_forge::AgentArray agents);

 private:
  /// Sets the height of an added attacker, and its z by the nearest vehicle of the frame.
  void rememberLike(const collision_forge::AgentArray& recorded);
  /// Returns true if it has left the scene at `stamp`. The trajectory must have points.
  bool hasLeft(const ros::Time& stamp) const;
  /// Returns the attacker's state at `time` (s), which is after t0.
  AgentState stateAfterNow(double time) const;
  /// Replaces the attacker in the frame by one with this state, or adds it.
  void put(const AgentState& state, collision_forge::AgentArray& agents) const;

  collision_forge::AttackerTrajectory trajectory_;
  DriveLimitOptions options_;
  AfterEnd after_end_;
  std::optional<PostCrashMotion> crash_;
  collision_forge::Agent attacker_;  // all but x, y, yaw and velocity, which put() sets
  bool is_remembered_ = false;       // height and z of `attacker_` are from a recorded frame
};

}  // namespace forge
