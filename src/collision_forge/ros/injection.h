#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>
#include <collision_forge/CollisionReport.h>

#include <string>

#include "collision_forge/geometry/pose2.h"

namespace forge {

/// Remembers what the trajectory does not say about an attacker (height, z), and puts it into
/// frames of agents. One that was added is as high, and stands as high, as the nearest recorded
/// vehicle of its class, or of another where there is none.
class AttackerInjector {
 public:
  explicit AttackerInjector(collision_forge::AttackerTrajectory trajectory);

  /// Drives on by another trajectory of the same vehicle from the same now, and keeps what it
  /// remembers; false, and nothing is changed, where it is of another attack.
  bool change(const collision_forge::AttackerTrajectory& trajectory);

  /// Takes height and z from a recorded frame, if the attacker is in it. inject() does so itself
  /// with frames up to the trajectory's start, and later ones where there was none.
  void remember(const collision_forge::AgentArray& recorded);

  /// Frames up to the trajectory's start pass as they are; an attacker that was added is put into
  /// those of its past, too, as a new agent. Later, the attacker is where its
  /// trajectory has it, whether it was recorded in that frame or not, and all others are as they
  /// were. After the trajectory's end the attacker is gone: the aftermath of a crash is not
  /// modelled.
  collision_forge::AgentArray inject(collision_forge::AgentArray agents);

 private:
  void rememberLike(const collision_forge::AgentArray& recorded);
  void put(const Pose2& pose, const Vector2& velocity, collision_forge::AgentArray& agents) const;

  collision_forge::AttackerTrajectory trajectory_;
  collision_forge::Agent attacker_;
  bool is_remembered_ = false;
};

/// Copies the bag at `in` to `out`: the attacker's recorded future in /agents and
/// /annotation_markers is replaced (one that was added is there from the first state of its past
/// on), the attack and the report against the recorded future are added (latched, at the
/// trajectory's start), every other message is copied byte for byte with its connection. Throws
/// BagError.
void injectIntoBag(const std::string& in, const std::string& out,
                   const collision_forge::Attack& attack,
                   const collision_forge::CollisionReport& tested_report);

}  // namespace forge
