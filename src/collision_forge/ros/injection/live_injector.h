#pragma once

#include <collision_forge/AgentArray.h>
#include <collision_forge/Attack.h>

#include <deque>
#include <functional>
#include <optional>
#include <vector>

#include "collision_forge/attack/verify/contact_watch.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/planner_test/settings/config.h"
#include "collision_forge/ros/injection/after_contact.h"
#include "collision_forge/ros/injection/attacker_injector.h"

namespace forge {

/// Publishes frames of agents with attacker and support vehicles of the newest attack. All times
/// are header stamps.
///
/// Without an attack, and up to its t0, recorded frames pass immediately. After t0 the injector
/// also publishes intermediate frames at `frame_rate` (config/attacked_bag.yaml), with the other
/// agents extrapolated by frameAfter(). It never extrapolates past the next expected recorded
/// frame; if a frame is late, the output is late.
///
/// Frames after t0 wait for an ego pose at their time or later, so that a contact is never shown
/// late. The stamps therefore do not depend on the order in which /tf and agents arrive. Stamps
/// increase, except when the replay steps back; a recorded frame older than the newest published
/// one is dropped. While time stands still, nothing is published.
///
/// After the first contact with the ego (ContactWatch), the attacker moves by PostCrashMotion if
/// `after_contact` is kStop. A replay that steps back to before the contact undoes the contact.
/// Not thread-safe.
class LiveInjector {
 public:
  /// Publishes a message.
  using Publish = std::function<void(const collision_forge::AgentArray&)>;

  /// `after_contact`: kStop or kDriveOn. `publish` is called inside addFrame(), addEgo() and
  /// setAttack(), once per frame, in the order of publication. `config`: frame rate, limits,
  /// severity, and the ego's size until setEgoSize(); copied.
  LiveInjector(const Config& config, AfterContact after_contact, Publish publish);

  /// Replaces the attack; an update of the same attack (AttackerInjector::change()) keeps its
  /// contact. An empty attack (isNone()) ends the injection. Throws MessageError as fromMessage()
  /// of the trajectory and InputError as checkTrajectory(); nothing changes then.
  void setAttack(const collision_forge::Attack& attack);

  /// Adds a recorded frame of agents (map frame, not null) and publishes all frames for which the
  /// injector need not wait any more; of more than 10,000 waiting frames the oldest is dropped. A
  /// frame more than kRestart older than its predecessor means that the replay stepped back;
  /// waiting frames are then dropped.
  void addFrame(const collision_forge::AgentArray::ConstPtr& recorded);

  /// Sets the size of the ego's box for all later poses, m.
  void setEgoSize(const BoxSize& size) { watch_.setEgoSize(size); }
  /// Adds a state of the ego's box middle (map frame, clock of the header stamps) and publishes as
  /// addFrame(). States must come in the order that EgoPoses returns them.
  void addEgo(const AgentState& ego);

 private:
  /// Passes the motion after the contact, if any, to the injector.
  void showCrash();
  /// Publishes all frames that are due.
  void send();
  /// Publishes the next intermediate frame; returns false if none is due.
  bool sendInBetween();
  /// Publishes or drops the first waiting frame; returns false if it must wait, or none is waiting.
  bool sendRecorded();
  void publish(const collision_forge::AgentArray& frame);
  /// Stores a recorded frame as `last_` unless it is older.
  void keep(const collision_forge::AgentArray::ConstPtr& recorded);
  /// Returns the time after `last_`, s, up to which intermediate frames may be published.
  double lastAhead() const;
  /// Returns true if `stamp` is after the attack's t0; false without an attack.
  bool isAfterNow(const ros::Time& stamp) const;
  /// Returns true if an ego pose at `stamp` or later was added.
  bool isEgoKnown(const ros::Time& stamp) const;

  double step_;  // s between published frames
  InputLimits limits_;
  AfterContact after_contact_;
  DriveLimitOptions drivable_;
  Publish publish_;

  std::optional<AttackerInjector> injector_;  // set during an attack
  std::vector<AttackerInjector> supports_;    // of its support vehicles
  double now_ = 0.0;                          // s, t0 of the attack
  ContactWatch watch_;

  std::deque<collision_forge::AgentArray::ConstPtr>
      waiting_;                                        // frames that wait for the ego's pose
  collision_forge::AgentArray::ConstPtr last_;         // newest recorded frame that left `waiting_`
  collision_forge::AgentArray::ConstPtr before_last_;  // the recorded frame before it
  ros::Time published_;                                // stamp of the newest published frame
  double begun_at_ =
      0.0;  // s, time of the ego when the attack arrived: minimum of intermediate frames
};

}  // namespace forge
