#pragma once

#include <collision_forge/Attack.h>

#include <deque>
#include <functional>
#include <mutex>
#include <optional>

#include "collision_forge/attack/policy/adaptive_attacker.h"

namespace forge {

/// Publishes attacks, and lets the newest one's attacker, if it sees and reacts, see the scene as
/// it comes: where its trajectory changes or it decides something, the attack is published again.
/// A scene from before the attack's now is of a replay that starts again: the attack is forgotten,
/// or, if it is to be kept, set out anew. Thread-safe.
class LiveAttacker {
 public:
  using Publish = std::function<void(const collision_forge::Attack&)>;
  /// `kept_for`: s of frames that an attack may be older than the scene when it sets out.
  LiveAttacker(Publish publish, bool keeps_attack, double kept_for)
      : publish_(std::move(publish)), keeps_attack_(keeps_attack), kept_for_(kept_for) {}

  /// Publishes a fixed attack. Nobody sees and reacts any more.
  void setOut(const collision_forge::Attack& attack);

  /// Publishes an attack of an attacker that sees and reacts, the task's; then that has seen what
  /// came since the task's now. Returns what was published first.
  collision_forge::Attack setOut(collision_forge::Attack attack, AttackerTask task,
                                 const AttackerSetup& setup);

  /// Publishes an attack by nobody (isNone()), so that one from elsewhere, as of a played bag,
  /// ends, too. Returns whether there was one of its own.
  bool forget();

  /// The newest frame of the scene; `clock`, s, is when it came. Where a replay goes back, but not
  /// to before the attack's now, an attacker that sees and reacts does so no more.
  void see(const Frame& frame, double clock);

  /// To be called now and then: where no frame has come since the call before, nor for `lost_after`
  /// seconds of the clock, the attacker is told that it sees nobody.
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
