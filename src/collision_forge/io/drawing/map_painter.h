#pragma once

#include "collision_forge/base/map/lane_map.h"
#include "collision_forge/io/drawing/canvas.h"

namespace forge {

/// Drivable area, lane borders, centrelines with arrow heads; connectors fainter. `line_width` in
/// pixels is that of a centreline.
void paintMap(Canvas& canvas, const Viewport& viewport, const LaneMap& map,
              const DrawingOptions& options, double line_width);

}  // namespace forge
