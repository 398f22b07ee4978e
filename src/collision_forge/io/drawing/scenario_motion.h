#pragma once

#include <optional>
#include <vector>

#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// A box that belongs to an agent of a class.
struct AgentBox {
  AgentClass agent_class = AgentClass::kCar;
  OrientedBox box;
};

/// Who is where when, past and future joined at now. The view must outlive it.
class ScenarioMotion {
 public:
  explicit ScenarioMotion(const ScenarioView& view) : view_(view) {}

  double now() const { return view_.snapshot.now; }
  /// The instant the picture is about: first contact. Without one: the time of the hit that the ego
  /// escapes, else the pattern's time.
  double keyTime() const;
  /// When both stand after the contact; keyTime() where the view has no such motion.
  double standTime() const;
  /// When an animation ends: the view's seconds_after_stand after standTime(), or earlier, where
  /// the view knows nothing later. Not before standTime().
  double endTime() const;

  /// Empty where nothing is known. From the contact on both move as the view's `crash` has it; they
  /// stay where they are in a view without it.
  std::optional<OrientedBox> egoAt(double time) const;
  std::optional<OrientedBox> attackerAt(double time) const;
  /// m/s; empty where nothing is known.
  std::optional<double> egoSpeedAt(double time) const;
  std::optional<double> attackerSpeedAt(double time) const;
  /// Where the recording has an attacker that is not added, from now on.
  std::optional<OrientedBox> recordedAttackerAt(double time) const;
  /// Everybody else; agents unknown at `time` are left out.
  std::vector<AgentBox> othersAt(double time) const;

  /// Those whose box at keyTime() stands where the ego or the attacker passed before: from where
  /// they were at that instant, the latest, to where they are at keyTime().
  struct Passed {
    AgentBox then;
    AgentBox at_key_time;
  };
  std::vector<Passed> passedOthers() const;

  /// Boxes every 0.1 s in [from, to], both ends included where known.
  std::vector<OrientedBox> egoBoxes(double from, double to) const;
  std::vector<OrientedBox> attackerBoxes(double from, double to) const;
  std::vector<OrientedBox> recordedAttackerBoxes(double from, double to) const;

  /// Where the boxes touch at contact. Without one: the middle between ego and attacker at the time
  /// of the hit that the ego escapes, else the middle between the pattern's boxes.
  Vector2 contactPoint() const;
  /// What a close-up looks at: the contact point, from the contact on moved as ego and attacker are
  /// in the mean.
  Vector2 closeUpCenter(double time) const;

 private:
  bool isAfterContact(double time) const;
  double lastKnownTime() const;
  /// The last instant before keyTime() at which the ego or the attacker covers some of `box`.
  std::optional<double> lastPassing(const OrientedBox& box) const;

  const ScenarioView& view_;
};

/// The attacker's box as the pattern asks for it, global map frame.
OrientedBox patternAttackerBox(const ScenarioView& view);

}  // namespace forge
