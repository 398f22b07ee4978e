#pragma once

#include <optional>
#include <string>

#include "collision_forge/attack/verify/post_crash_motion.h"
#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/collision_request.h"
#include "collision_forge/base/scene/scene.h"

namespace forge {

/// Everything a picture of one generated collision shows. All times on the scene's clock, all poses
/// in the global map frame.
struct ScenarioView {
  std::string scene_name;
  double tta = 0.0;  ///< seconds from now, as requested
  Mode mode = Mode::kHistory;

  /// Up to now: the map and the driven trails of the ego, the attacker and the others. The
  /// animation starts as early as these tracks allow, so give it more frames than the prediction
  /// needs.
  Snapshot snapshot;
  /// From now on: the ego and the others. A track of the attacker's id in here
  /// is drawn pale: what it did in the recording.
  Future future;

  CollisionPattern pattern;       ///< the asked-for boxes, drawn as outlines
  AttackerTrajectory trajectory;  ///< what the attacker drives instead
  CollisionReport report;         ///< of that trajectory against `future`, the recording
  /// What ego and attacker do after the contact of the report; without it the picture shows nothing
  /// later than the contact.
  std::optional<PostCrashMotion> crash = {};
  double seconds_after_stand = 0.0;  ///< that an animation goes on after both stand

  /// Empty for an attack. For a test of a planner: the planner, as tables name it. `future.ego` is
  /// then the ego as the planner drives it, and of the report only the contact is shown.
  std::string planner = {};
  /// For the escape from a hit, which has no contact: the time of the hit.
  std::optional<double> escaped_hit = {};
};

inline bool hasContact(const ScenarioView& view) { return view.report.contact; }
/// Whether the picture shows where ego and attacker come to a stand.
inline bool hasRest(const ScenarioView& view) { return hasContact(view) && view.crash; }

}  // namespace forge
