#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// The content of a picture of one generated collision. Times on the scene's clock, poses in the
/// global map frame.
struct ScenarioView {
  std::string scene_name;
  double tta = 0.0;  ///< requested TTA, s
  Mode mode = Mode::kHistory;

  /// Up to t0: the map and the past of the ego, the attacker and the other agents. Animations start
  /// as early as these tracks allow, so include more frames than the prediction needs.
  Snapshot snapshot;
  /// From t0 on: the ego and the other agents. A track with the attacker's id is drawn pale: its
  /// recorded motion.
  Future future;

  CollisionPattern pattern;                ///< predicted boxes, drawn as outlines
  AttackerTrajectory trajectory;           ///< the attacker's motion
  CollisionReport report;                  ///< report on `trajectory` against `future`
  std::vector<std::string> supports = {};  ///< ids of agents that are support vehicles
  /// Motion of ego and attacker after the contact of `report`; empty: both stay at their contact
  /// poses and animations end at the contact.
  std::optional<PostCrashMotion> crash = {};
  /// s that an animation goes on after both vehicles have stopped.
  double seconds_after_stand = 0.0;

  /// Planner test: the planner's name in tables; `future.ego` is then the ego driven by the
  /// planner, and only the contact of the report is shown. "" for an attack.
  std::string planner = {};
  /// Avoided hit of a planner test: the time, s on the scene's clock, at which the ego would have
  /// been hit; `report` has no contact. Empty: no such hit.
  std::optional<double> avoided_hit = {};
  std::vector<TrafficLight> lights = {};  ///< as Scene::lights, on the same clock
};

/// Returns true if the attacker touches the ego.
inline bool hasContact(const ScenarioView& view) { return view.report.contact; }
/// Returns true if the picture shows where ego and attacker come to rest.
inline bool hasRest(const ScenarioView& view) { return hasContact(view) && view.crash; }

}  // namespace forge
