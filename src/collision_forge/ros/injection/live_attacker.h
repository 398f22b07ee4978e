#pragma once

#include <collision_forge/Attack.h>

#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "collision_forge/attack/policy/adaptive_attacker.h"

namespace forge {

/// Publishes attacks, and runs the adaptive attacker of the newest attack on each frame of the
/// scene. Publishes the attack again when its trajectory changes or the attacker makes a decision.
/// A frame at or before the attack's t0 that is older than its predecessor means that the replay
/// restarted. Without `keeps_attack` the attack is then dropped (end()). With it, a fixed attack
/// stays without being published again; an adaptive one returns to its state at t0 and is published
/// as at first, in its first plan.
/// Thread-safe; `publish` is called with a lock held and must not call back.
class LiveAttacker {
 public:
  /// Publishes a message; called in the thread of the function that publishes.
  using Publish = std::function<void(const collision_forge::Attack&)>;
  /// `kept_for`: s; frames older than the newest by more than this are dropped. An adaptive attack
  /// whose t0 is older misses the frames between.
  LiveAttacker(Publish publish, bool keeps_attack, double kept_for)
      : publish_(std::move(publish)), keeps_attack_(keeps_attack), kept_for_(kept_for) {}

  /// Publishes an attack with a fixed trajectory; ends the adaptive one, if any, without publishing
  /// its end.
  void start(const collision_forge::Attack& attack);

  /// Creates the adaptive attacker of `task`, publishes `attack`, which is the message of its first
  /// plan, and then passes the kept frames after the task's t0 to the attacker, as see() does.
  /// Returns the attack as first published: with the plans of the attacker (setPlans()).
  collision_forge::Attack start(collision_forge::Attack attack, AttackerTask task,
                                const AttackerSetup& setup);

  /// Publishes an empty attack (isNone()), which also ends an attack of another source, such as a
  /// played bag. Returns true if this object had an attack, fixed or adaptive.
  bool end();

  /// Keeps a new frame, received at `clock` (s, ROS time), and passes it to the adaptive attacker
  /// if it is after the attack's t0; publishes the attack if that changes it. If the replay steps
  /// back, but not to the attack's t0 or before it, the attacker stops replanning, with a warning
  /// in the log.
  void addFrame(const Frame& frame, double clock);

  /// Call periodically; `clock`: s, ROS time. If no frame arrived since the last call and for
  /// AdaptiveOptions::lost_after seconds of the clock, the adaptive attacker gets an update step
  /// without observations.
  void checkForLostFrames(double clock);

 private:
  /// An adaptive attack.
  struct Driven {
    collision_forge::Attack first;  // as first published
    AttackerTask task;
    AttackerSetup setup;
    AdaptiveAttacker start;                  // its state at t0, for a restart
    std::optional<AdaptiveAttacker> policy;  // empty: the replay stepped back during the attack
  };

  // All functions below need the lock.
  void publish(const collision_forge::Attack& attack);  // also sets `now_`
  void forgetLocked();
  void show(const Frame& frame);  // passes a frame after t0 to the attacker; publishes a change
  void goBackTo(double time);     // handles a replay that steps back to `time` (s)
  collision_forge::Attack attackNow() const;  // the message with the newest plan

  std::mutex mutex_;  // guards all members below
  Publish publish_;
  bool keeps_attack_;
  double kept_for_;
  std::optional<double> now_;  // s, t0 of the current attack
  std::deque<Frame> frames_;   // of the last `kept_for_` s, oldest first, for start()
  double came_ = 0.0;          // s, clock at which the newest frame was received
  bool is_watched_ = false;    // checkForLostFrames() was called since the newest frame
  std::optional<Driven> driven_;
};

}  // namespace forge
