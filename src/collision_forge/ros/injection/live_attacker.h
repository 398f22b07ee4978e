#pragma once

#include <collision_forge/Attack.h>

#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "collision_forge/attack/policy/adaptive_attacker.h"

namespace forge {

/// Publishes attacks and updates the newest one's adaptive attacker with each frame of the scene:
/// publishes the attack again when its trajectory changes or the attacker makes a decision. A frame
/// from before the attack's t0 means that the replay restarted: the attack is dropped, or, with
/// `keeps_attack`, started again. Thread-safe.
class LiveAttacker {
 public:
  using Publish = std::function<void(const collision_forge::Attack&)>;
  /// `kept_for`: s of frames that an attack may be older than the scene when it sets out.
  LiveAttacker(Publish publish, bool keeps_attack, double kept_for)
      : publish_(std::move(publish)), keeps_attack_(keeps_attack), kept_for_(kept_for) {}

  /// Publishes a fixed attack and ends the previous adaptive one.
  void setOut(const collision_forge::Attack& attack);

  /// Publishes an attack of an attacker that sees and reacts, the task's; then that has seen what
  /// came since the task's now. Returns what was published first.
  collision_forge::Attack setOut(collision_forge::Attack attack, AttackerTask task,
                                 const AttackerSetup& setup);

  /// Publishes an empty attack (isNone()), which also ends attacks from other sources such as a
  /// played bag. Returns true if this object had an attack.
  bool forget();

  /// The newest frame of the scene; `clock`, s, is when it came. Where a replay goes back, but not
  /// to before the attack's now, an attacker that sees and reacts does so no more.
  void see(const Frame& frame, double clock);

  /// Call periodically. If no frame came since the previous call nor for `lost_after` s of the
  /// clock, the attacker gets a frame without observations.
  void watch(double clock);

 private:
  struct Driven {
    collision_forge::Attack first;
    AttackerTask task;
    AttackerSetup setup;
    AdaptiveAttacker start;
    std::optional<AdaptiveAttacker> policy;  // empty: a replay went back while it was driving
  };

  void publish(const collision_forge::Attack& attack);
  void forgetLocked();
  void show(const Frame& frame);
  void goBackTo(double time);
  collision_forge::Attack attackNow() const;

  std::mutex mutex_;  // of all that follows
  Publish publish_;
  bool keeps_attack_;
  double kept_for_;
  std::optional<double> now_;  // of the attack that there is
  std::deque<Frame> frames_;   // the newest: a request is answered later than its now
  double came_ = 0.0;          // s, the clock when the newest came
  bool is_watched_ = false;    // since the newest came
  std::optional<Driven> driven_;
};

}  // namespace forge
