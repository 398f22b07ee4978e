#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/policy/attacker_policy.h"
#include "collision_forge/planner_test/planners/background_model.h"
#include "collision_forge/planner_test/planners/idm.h"
#include "collision_forge/planner_test/trials/crash_scenario.h"

namespace forge {

/// How other agents move: as recorded (kReplay), as recorded but delayed by the intelligent driver
/// model (kIdm), or by a learned model (kModel); see Traffic.
enum class Background { kReplay, kIdm, kModel };
/// Returns "replay", "idm" or "model".
const char* toString(Background background);
/// Returns the value of a name as toString() spells it; nullopt for another name.
std::optional<Background> backgroundFromString(const std::string& name);

/// Simulates all agents except the ego, step by step. The attacker's policy observes every step
/// before it moves the attacker; other agents replay their recorded tracks. With kIdm, a motor
/// vehicle that moves at least 2 m in the recording drives its recorded path at its own time: the
/// intelligent driver model delays it behind the ego, the attacker or another agent, and it catches
/// up no faster than the model accelerates. No agent is ever ahead of its recording; each such
/// vehicle is in sight until it has driven all of its recorded path. With kModel, the learned model
/// moves every agent but static objects from its first recorded state after t0 on; an agent that is
/// not among those nearest to the ego keeps its velocity.
class Traffic {
 public:
  /// `attacker`: policy of the attacker (not null), starting with the scenario's trajectory. `idm`:
  /// used with kIdm. `history`: s of past states in agents(). `model`: not null with kModel, else
  /// null; copies share it, so they must not run at the same time. The scenario is copied as far as
  /// needed.
  Traffic(const CrashScenario& scenario, std::unique_ptr<AttackerPolicy> attacker,
          Background background, const IdmOptions& idm, double history,
          std::shared_ptr<BackgroundModel> model = nullptr);
  /// Copies the state, including a clone of the attacker's policy.
  Traffic(const Traffic& other);

  /// Returns the current time, s, scene clock; t0 at first.
  double time() const { return time_; }
  /// Returns the agents in sight at time(), the ego excluded, the attacker (if in sight) first,
  /// each with its states of the last `history` seconds, the newest at time(). Velocities are
  /// estimated from past states only; the attacker's come from its trajectory. The reference is
  /// valid until the next advance().
  const std::vector<Track>& agents() const { return agents_; }

  /// Returns the attacker's policy, as of time().
  const AttackerPolicy& attacker() const { return *attacker_; }

  /// Moves all agents to `time` (s, scene clock, > time()). `ego`: the ego's track; its newest
  /// state must be at time(). Throws as BackgroundModel::next().
  void advance(double time, const Track& ego);

 private:
  /// An agent and its motion.
  struct Driver {
    Track recorded;  ///< from t0 on; the attacker's trajectory
    Track shown;     ///< up to time()
    bool is_attacker = false;
    double clock = 0.0;  ///< s, recorded time of its position
    /// For vehicles that react: recorded path and the arc length of each recorded state on it.
    std::optional<Polyline> way;
    std::vector<double> arc_lengths;
    double speed = 0.0;         ///< m/s
    double top_speed = 0.0;     ///< m/s, the highest recorded
    bool is_modelled = false;   ///< the learned model moves it
    std::optional<Pose2> pose;  ///< of a modelled agent at time(), once it was in sight
  };

  /// Sets `way`, arc lengths and speeds of a vehicle that reacts.
  static void prepareToReact(Driver& driver);
  /// Appends the ego's state to ego_history_.
  void remember(const AgentState& ego);
  /// Sets the poses of the modelled agents at `time` (s, scene clock).
  void moveModelled(double time);
  /// Moves the recorded time of an agent on to `time`; with kIdm behind its lead among `in_sight`.
  void drive(Driver& driver, double time, const std::vector<Track>& in_sight) const;
  /// Appends the agent's state at time_ to `shown`, if it is in sight. `step`: s since the previous
  /// one.
  void show(Driver& driver, double step) const;
  /// Sets agents_ to the agents in sight.
  void collect();

  std::unique_ptr<AttackerPolicy> attacker_;
  IdmOptions idm_;
  double history_;
  double time_;
  std::shared_ptr<BackgroundModel> model_;
  std::vector<TrajectoryPoint> ego_history_;  // of the last `history_` seconds, for the model
  std::vector<Driver> drivers_;
  std::vector<Track> agents_;
};

}  // namespace forge
