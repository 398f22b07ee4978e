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
  /// m, global map frame: positions on the attackers' trajectories, about 5 m apart.
  std::vector<Vector2> places;

  /// Extends the interval to contain [`from`, `to`] (s, scene clock) and appends the positions of
  /// `points`, an attacker's trajectory. An empty extent takes the interval as it is.
  void include(double from, double to, const std::vector<TrajectoryPoint>& points);
};

/// Returns the page's record of a scene (JSON): the recorded ego in the interval, other agents that
/// come within `options.map_margin` of the bounding box of the ego's positions and `extent.places`,
/// and the map within that margin around these positions. Times are relative to the scene's first
/// frame.
std::string sceneRecord(const Scene& scene, const SceneExtent& extent,
                        const ReportOptions& options);

}  // namespace forge
