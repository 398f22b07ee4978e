#pragma once

#include "collision_forge/drawing/canvas.h"
#include "collision_forge/map/lane_map.h"

namespace forge {

/// Drivable area, lane borders, centrelines with arrow heads; connectors fainter. `line_width` in
/// pixels is that of a centreline.
void paintMap(Canvas& canvas, const Viewport& viewport, const LaneMap& map,
              const DrawingOptions& options, double line_width);

}  // namespace forge
