#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// How everybody but ego and attacker moves.
enum class Background { kReplay, kIdm };
/// "replay", "idm".
const char* toString(Background background);
std::optional<Background> backgroundFromString(const std::string& name);

/// Everybody but the ego, step by step. The attacker looks at every step before it is driven, and
/// follows its policy's trajectory; the others replay their recorded tracks. With kIdm a vehicle
/// that the recording moves drives its recorded way by a clock of its own, which falls behind the
/// recording where the intelligent driver model says that somebody (the ego, the attacker, another)
/// is in its way, and catches up no faster than the model accelerates. Nobody is ever ahead of the
/// recording.
class Traffic {
 public:
  /// `history`: seconds of past states that agents() holds. `attacker`: who drives the attacker,
  /// from the scenario's trajectory on.
  Traffic(const CrashScenario& scenario, std::unique_ptr<AttackerPolicy> attacker,
          Background background, const IdmOptions& idm, double history);
  Traffic(const Traffic& other);

  double time() const { return time_; }
  /// Those in sight now, each with its states of the last `history` seconds, the newest at time().
  /// Velocities are told from the past alone, the attacker's from its trajectory.
  const std::vector<Track>& agents() const { return agents_; }

  const AttackerPolicy& attacker() const { return *attacker_; }

  /// On to `time` (> time()); `ego` has its newest state at time().
  void advance(double time, const Track& ego);

 private:
  struct Driver {
    Track recorded;  ///< from now on; the attacker's its trajectory
    Track shown;     ///< up to time()
    bool is_attacker = false;
    double clock = 0.0;  ///< s, recorded time of where it is
    /// Of those that look out for others: their recorded way, the arc length of each state on it.
    std::optional<Polyline> way;
    std::vector<double> arc_lengths;
    double speed = 0.0;      ///< m/s
    double top_speed = 0.0;  ///< m/s, the highest recorded
  };

  static void prepareToReact(Driver& driver);
  void drive(Driver& driver, double time, const std::vector<Track>& in_sight) const;
  void show(Driver& driver, double step) const;
  void collect();

  std::unique_ptr<AttackerPolicy> attacker_;
  IdmOptions idm_;
  double history_;
  double time_;
  std::vector<Driver> drivers_;
  std::vector<Track> agents_;
};

}  // namespace forge
