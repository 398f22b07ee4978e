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
#include "collision_forge/ros/injection/attacker_injector.h"
#include "collision_forge/ros/injection/injection.h"

namespace forge {

/// Publishes frames of agents with attacker and support vehicles of the newest attack.
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

  /// `after_contact`: kStop or kDriveOn. `publish` is called inside addFrame() and addEgo().
  LiveInjector(const Config& config, AfterContact after_contact, Publish publish);

  /// Replaces the attack; an update of the same attack (AttackerInjector::change()) keeps its
  /// contact. An empty attack ends the injection. On MessageError and InputError nothing changes.
  void setAttack(const collision_forge::Attack& attack);

  /// Adds a recorded frame of agents and publishes the frames that it completes.
  void addFrame(const collision_forge::AgentArray::ConstPtr& recorded);

  /// Sets the size of the ego's box for all later poses, m.
  void setEgoSize(const BoxSize& size) { watch_.setEgoSize(size); }
  /// Adds a pose of the ego's box middle; times as in EgoPoses.
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

  std::optional<AttackerInjector> injector_;  // set during an attack
  std::vector<AttackerInjector> supports_;    // of its support vehicles
  double now_ = 0.0;                          // s, t0 of the attack
  ContactWatch watch_;

  std::deque<collision_forge::AgentArray::ConstPtr>
      waiting_;                                 // frames that wait for the ego's pose
  collision_forge::AgentArray::ConstPtr last_;  // newest published recorded frame
  collision_forge::AgentArray::ConstPtr before_last_;
  ros::Time published_;  // stamp of the newest frame
  double begun_at_ =
      0.0;  // s, time of the ego when the attack arrived: minimum of intermediate frames
};

}  // namespace forge
