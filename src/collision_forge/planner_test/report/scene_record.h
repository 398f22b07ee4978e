#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/report/options.h"

namespace forge {

/// Part of a scene that its attacks need; empty at first.
struct SceneExtent {
  double begin = 0.0;           ///< s, scene clock
  double end = 0.0;             ///< s, scene clock
  std::vector<Vector2> places;  ///< m, positions on the attackers' paths

  /// Extends the interval to [`from`, `to`] (s, scene clock) and adds the positions of `points`;
  /// the first call sets it.
  void include(double from, double to, const std::vector<TrajectoryPoint>& points);
};

/// Returns the page's record of a scene (JSON): the recorded ego, other agents and the map, within
/// the extent and `options.map_margin` around it.
std::string sceneRecord(const Scene& scene, const SceneExtent& extent,
                        const ReportOptions& options);

}  // namespace forge
