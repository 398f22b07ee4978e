#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>

#include <deque>
#include <functional>
#include <optional>

#include "collision_forge/attack/verify/contact_watch.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/injection/attacker_injector.h"
#include "collision_forge/ros/injection/injection.h"

namespace forge {

/// Publishes frames of agents with the newest attack in them.
///
/// Without an attack, and up to its now, recorded frames pass at once. After its now there are also
/// frames in between, `frame_rate` (config/attacked_bag.yaml) a second from a recorded one on:
/// other agents as in frameAfter(). None is where the next recorded one is awaited, or half a
/// step before it: until that has come, no more than the gap between the last two is filled.
///
/// A frame after the attack's now waits until the ego's pose is known at its time or later, so that
/// a contact is never shown late: where /tf lags, so do the frames. The stamps are thus the same in
/// whatever order /tf and agents come. They grow, but where a replay goes back: a recorded frame
/// that is older than what was published is left out. Where time stands still, nothing is
/// published.
///
/// From the attacker's first contact with the ego on (ContactWatch), the attacker moves as of
/// PostCrashMotion, unless `after_contact` is kDriveOn. A replay that goes back to before the
/// contact undoes it. Not thread-safe.
class LiveInjector {
 public:
  using Publish = std::function<void(const collision_forge::AgentArray&)>;

  /// `after_contact`: kStop or kDriveOn; a replay has no end to set.
  LiveInjector(const Config& config, AfterContact after_contact, Publish publish);

  /// Replaces the attack; an update of the same attack (AttackerInjector::change()) keeps the
  /// contact. An empty attack (isNone()) ends it. Throws MessageError and InputError, and changes
  /// nothing.
  void setAttack(const collision_forge::Attack& attack);

  void addFrame(const collision_forge::AgentArray::ConstPtr& recorded);

  /// Middle of the ego's box; times as of EgoPoses.
  void addEgo(const AgentState& ego);

 private:
  void showCrash();
  void send();
  bool sendInBetween();
  bool sendRecorded();
  void publish(const collision_forge::AgentArray& frame);
  void keep(const collision_forge::AgentArray::ConstPtr& recorded);
  double lastAhead() const;
  bool isAfterNow(const ros::Time& stamp) const;
  bool isEgoKnown(const ros::Time& stamp) const;

  double step_;  // s between frames
  InputLimits limits_;
  AfterContact after_contact_;
  DriveLimitOptions drivable_;
  Publish publish_;

  std::optional<AttackerInjector> injector_;  // while there is an attack
  double now_ = 0.0;                          // s, of the attack
  ContactWatch watch_;

  std::deque<collision_forge::AgentArray::ConstPtr> waiting_;  // for the ego's poses
  collision_forge::AgentArray::ConstPtr last_;                 // recorded frame that was published
  collision_forge::AgentArray::ConstPtr before_last_;
  ros::Time published_;    // stamp of the newest frame
  double begun_at_ = 0.0;  // s; frames in between are later than the ego was when the attack came
};

}  // namespace forge
