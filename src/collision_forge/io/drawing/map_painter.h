#pragma once

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/drawing/canvas.h"

namespace forge {

/// Paints walkways, drivable area, features except driveways, lane borders, and centrelines with
/// arrow heads in driving direction; connectors fainter. `line_width`: of a centreline, pixels.
void paintMap(Canvas& canvas, const Viewport& viewport, const LaneMap& map,
              const DrawingOptions& options, double line_width);

}  // namespace forge
