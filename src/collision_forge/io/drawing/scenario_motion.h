#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// The box and class of an agent.
struct AgentBox {
  AgentClass agent_class = AgentClass::kCar;
  OrientedBox box;
  bool is_support = false;  ///< one of ScenarioView::supports
};

/// Poses of all vehicles of a view over time, past and future joined at t0. Times: s on the scene's
/// clock. The view must outlive it.
class ScenarioMotion {
 public:
  explicit ScenarioMotion(const ScenarioView& view) : view_(view) {}

  /// Returns t0, s.
  double now() const { return view_.snapshot.now; }
  /// Returns the time that a picture shows: the contact time; without a contact, the time of the
  /// hit that the ego avoids, else the pattern's time.
  double keyTime() const;
  /// Returns the time at which both vehicles stand after the contact; keyTime() if the view has no
  /// post-crash motion.
  double standTime() const;
  /// Returns the end of an animation: standTime() plus the view's seconds_after_stand, at most the
  /// last known time, at least standTime().
  double endTime() const;

  /// Return the box at `time`; nullopt for times without a known pose. From the contact on, the
  /// vehicles move by the view's `crash`; without it they stay at their contact poses.
  std::optional<OrientedBox> egoAt(double time) const;
  std::optional<OrientedBox> attackerAt(double time) const;
  /// Returns the speed in m/s; nullopt for unknown times.
  std::optional<double> egoSpeedAt(double time) const;
  std::optional<double> attackerSpeedAt(double time) const;
  /// Returns the recorded box of a recorded attacker, from t0 on; nullopt for an added one.
  std::optional<OrientedBox> recordedAttackerAt(double time) const;
  /// Returns the other agents whose pose at `time` is known.
  std::vector<AgentBox> otherAgentsAt(double time) const;

  /// Another agent whose box at keyTime() covers ground that the ego or the attacker passed
  /// earlier: `then` is its box at the last such time.
  struct Passed {
    AgentBox then;
    AgentBox at_key_time;
  };
  /// Returns all such agents. A still picture would otherwise seem to show overlaps.
  std::vector<Passed> passedAgents() const;

  /// Return boxes every 0.1 s in [from, to], both ends included, where known.
  std::vector<OrientedBox> egoBoxes(double from, double to) const;
  std::vector<OrientedBox> attackerBoxes(double from, double to) const;
  std::vector<OrientedBox> recordedAttackerBoxes(double from, double to) const;

  /// Returns touchPoint() at contact. Without a contact: the middle between ego and attacker at the
  /// time of the hit that the ego avoids, else between the pattern's boxes.
  Vector2 contactPoint() const;
  /// Returns the centre of a close-up: the contact point, which after the contact moves by the mean
  /// displacement of ego and attacker.
  Vector2 closeUpCenter(double time) const;

 private:
  bool isSupport(const std::string& id) const;
  bool isAfterContact(double time) const;
  double lastKnownTime() const;
  /// Returns the last time before keyTime() at which the ego or the attacker overlaps `box`.
  std::optional<double> lastPassing(const OrientedBox& box) const;

  const ScenarioView& view_;
};

/// Returns the attacker's box in the predicted pattern, global map frame.
OrientedBox patternAttackerBox(const ScenarioView& view);

}  // namespace forge
