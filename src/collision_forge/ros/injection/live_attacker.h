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
/// A frame before the attack's t0 means that the replay restarted: the attack is dropped, or, with
/// `keeps_attack`, started again. Thread-safe; `publish` is called with a lock held and must not
/// call back.
class LiveAttacker {
 public:
  /// Publishes a message.
  using Publish = std::function<void(const collision_forge::Attack&)>;
  /// `kept_for`: s of frames that are kept; an attack may be this much older than the newest frame.
  LiveAttacker(Publish publish, bool keeps_attack, double kept_for)
      : publish_(std::move(publish)), keeps_attack_(keeps_attack), kept_for_(kept_for) {}

  /// Publishes an attack with a fixed trajectory; ends an adaptive one.
  void setOut(const collision_forge::Attack& attack);

  /// Publishes an adaptive attack for `task`, then replays the frames received since the task's t0
  /// to its attacker. Returns the attack as first published.
  collision_forge::Attack setOut(collision_forge::Attack attack, AttackerTask task,
                                 const AttackerSetup& setup);

  /// Publishes an empty attack (isNone()), which also ends an attack of another source, such as a
  /// played bag. Returns true if this object had an attack.
  bool forget();

  /// Passes a new frame, received at `clock` (s), to the adaptive attacker. If the replay steps
  /// back, but not to before the attack's t0, the attacker stops replanning.
  void see(const Frame& frame, double clock);

  /// Call periodically. If no frame arrived since the last call and for `lost_after` seconds of the
  /// clock, the attacker gets an update step without observations.
  void watch(double clock);

 private:
  struct Driven {
    collision_forge::Attack first;
    AttackerTask task;
    AttackerSetup setup;
    AdaptiveAttacker start;
    std::optional<AdaptiveAttacker> policy;  // empty: the replay stepped back during the attack
  };

  void publish(const collision_forge::Attack& attack);
  void forgetLocked();
  void show(const Frame& frame);
  void goBackTo(double time);
  collision_forge::Attack attackNow() const;

  std::mutex mutex_;  // guards all members below
  Publish publish_;
  bool keeps_attack_;
  double kept_for_;
  std::optional<double> now_;  // s, t0 of the current attack
  std::deque<Frame> frames_;   // the newest: a request ends later than its t0
  double came_ = 0.0;          // s, clock at which the newest was received
  bool is_watched_ = false;    // watch() was called since the newest frame
  std::optional<Driven> driven_;
};

}  // namespace forge
