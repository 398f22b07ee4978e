#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/report/options.h"

namespace forge {

/// Part of a scene that the page shows: an interval and the surroundings of its attacks. Empty if
/// `begin` equals `end`, as at first.
struct SceneExtent {
  double begin = 0.0;  ///< s, scene clock
  double end = 0.0;    ///< s, scene clock
  /// m, global map frame: positions on the attackers' trajectories, each at least 5 m from the one
  /// before.
  std::vector<Vector2> places;

  /// Extends the interval to contain [`from`, `to`] (s, scene clock) and appends positions of
  /// `points`, an attacker's trajectory, that are at least 5 m apart. An empty extent takes the
  /// interval as it is.
  void include(double from, double to, const std::vector<TrajectoryPoint>& points);
};

/// Returns the page's record of a scene (one line of JSON without a line end): the recorded ego in
/// the interval, other agents whose middle comes within `options.map_margin` of the bounding box of
/// the ego's positions and `extent.places` (with all their states in the interval), and the map
/// within that margin around these positions; without a map, the key "map" is missing. Times are
/// relative to the scene's first frame. Keys: "name", "origin" (s, scene clock, the first frame),
/// "length" and "width" (m, of the ego), "ego" (writeStates()), "agents" and "map".
std::string sceneRecord(const Scene& scene, const SceneExtent& extent,
                        const ReportOptions& options);

}  // namespace forge
