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
  bool is_support = false;  ///< true: a support vehicle, one of ScenarioView::supports
};

/// Poses of all vehicles of a view over time, past and future joined at t0: the past up to t0, the
/// future after it. Times: s on the scene's clock. Boxes and points: global map frame. The view
/// must outlive it.
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

  /// Returns the ego's box at `time`; nullopt for times without a known pose. From the contact on,
  /// the ego moves by the view's `crash`; without `crash` it stays at its contact pose.
  std::optional<OrientedBox> egoAt(double time) const;
  /// Returns the attacker's box at `time`, as egoAt(): up to t0 its recorded or added past, then
  /// its trajectory.
  std::optional<OrientedBox> attackerAt(double time) const;
  /// Returns the ego's recorded or planned speed in m/s, without the effect of a contact; nullopt
  /// for unknown times.
  std::optional<double> egoSpeedAt(double time) const;
  /// Returns the speed in m/s along the attacker's trajectory; nullopt before t0 and after its end.
  std::optional<double> attackerSpeedAt(double time) const;
  /// Returns the recorded box of a recorded attacker, from t0 on; nullopt for an added one.
  std::optional<OrientedBox> recordedAttackerAt(double time) const;
  /// Returns the other agents (all but ego and attacker) whose pose at `time` is known, in the
  /// order of the tracks.
  std::vector<AgentBox> otherAgentsAt(double time) const;

  /// Another agent whose box at keyTime() covers ground that the ego or the attacker passed
  /// earlier: `then` is its box at the last such time.
  struct Passed {
    AgentBox then;
    AgentBox at_key_time;
  };
  /// Returns all such agents, in the order of ScenarioView::future, `then` at a multiple of 0.1 s
  /// after t0, before keyTime(); AgentBox::is_support is not set. A still picture would otherwise
  /// seem to show overlaps.
  std::vector<Passed> passedAgents() const;

  /// Returns the ego's boxes every 0.1 s after `from`, both ends `from` and `to` included, so that
  /// the last step may be shorter; times without a known pose are left out.
  std::vector<OrientedBox> egoBoxes(double from, double to) const;
  /// As egoBoxes() for attackerAt().
  std::vector<OrientedBox> attackerBoxes(double from, double to) const;
  /// As egoBoxes() for recordedAttackerAt().
  std::vector<OrientedBox> recordedAttackerBoxes(double from, double to) const;

  /// Returns touchPoint() at contact. Without a contact: the middle between ego and attacker at the
  /// time of the hit that the ego avoids, else (no such hit, or a pose is unknown) between the
  /// centres of the pattern's boxes.
  Vector2 contactPoint() const;
  /// Returns the centre of a close-up: the contact point, which after the contact moves by the mean
  /// displacement of ego and attacker.
  Vector2 closeUpCenter(double time) const;

 private:
  /// Returns true if `id` is one of ScenarioView::supports.
  bool isSupport(const std::string& id) const;
  /// Returns true if the view has a contact and `time` is not before it.
  bool isAfterContact(double time) const;
  /// Returns the last time of the recording; without a contact, the end of the motion of ego or
  /// attacker, the earlier one.
  double lastKnownTime() const;
  /// Returns the last time from t0 to before keyTime() at which the ego or the attacker overlaps
  /// `box`; nullopt: never.
  std::optional<double> lastPassing(const OrientedBox& box) const;

  const ScenarioView& view_;
};

/// Returns the attacker's box in the predicted pattern, global map frame.
OrientedBox patternAttackerBox(const ScenarioView& view);

}  // namespace forge
