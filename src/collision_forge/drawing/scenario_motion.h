#pragma once

#include <optional>
#include <vector>

#include "collision_forge/drawing/scenario_view.h"

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
  /// The instant the picture is about: first contact, or the pattern's time without one.
  double keyTime() const;

  /// Empty where nothing is known. From contact on both stay at their contact poses.
  std::optional<OrientedBox> egoAt(double time) const;
  std::optional<OrientedBox> attackerAt(double time) const;
  /// Everybody else; agents unknown at `time` are left out.
  std::vector<AgentBox> othersAt(double time) const;

  /// Boxes every 0.1 s in [from, to], both ends included where known.
  std::vector<OrientedBox> egoBoxes(double from, double to) const;
  std::vector<OrientedBox> attackerBoxes(double from, double to) const;

  /// Where the boxes touch at contact; the middle between the pattern's boxes without one.
  Vector2 contactPoint() const;

 private:
  bool frozenAt(double time) const;

  const ScenarioView& view_;
};

/// The attacker's box as the pattern asks for it, global map frame.
OrientedBox patternAttackerBox(const ScenarioView& view);

}  // namespace forge
