#pragma once

#include <vector>

#include "collision_forge/io/lidar/lidar_ray.h"
#include "collision_forge/io/lidar/sweep_rings.h"

namespace forge {

/// Step of raysOf(): sets the directions of the rays without return in `rays`, one ray per point of
/// `seen`, and if `may_add` appends the rays for which the cloud has no point, by the rules of
/// raysOf(). Returns false, and changes nothing, if the azimuths have no regular step. At least one
/// point must have its ring set. `elevations`: elevationsOf() `seen`.
bool rebuildMissingRays(const std::vector<SeenPoint>& seen, const RingElevations& elevations,
                        bool may_add, std::vector<LidarRay>& rays);

}  // namespace forge
