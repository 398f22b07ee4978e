#pragma once

#include <string>
#include <vector>

#include "collision_forge/base/scene/attack.h"
#include "collision_forge/base/scene/scene.h"
#include "collision_forge/planner_test/report/options.h"

namespace forge {

/// How much of a scene its attacks need. Begins empty.
struct SceneExtent {
  double begin = 0.0;  ///< s, the scene's clock
  double end = 0.0;
  std::vector<Vector2> places;  ///< where the attackers drive

  /// Widens it; the first call sets it.
  void include(double from, double to, const std::vector<TrajectoryPoint>& points);
};

/// What the page shows of a scene, as JSON: the recorded ego, the others and the map, all within
/// the extent and the margin of the options around it.
std::string sceneRecord(const Scene& scene, const SceneExtent& extent,
                        const ReportOptions& options);

}  // namespace forge
