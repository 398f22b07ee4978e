#pragma once

#include <string>

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/planner_test/sweeps/sweep_map.h"

namespace forge {

/// Draws the panels of a map as a PNG of `options.png_width` pixels, with axes, a legend, and in a
/// grid a line between hits and avoided crashes. `title` is the first line above the panels, `note`
/// the second; both are shortened to the width of the picture. Writes to an AsideFile. Throws
/// std::runtime_error naming `path` if it cannot be written.
void drawSweepMap(const std::string& path, const SweepMap& map, const std::string& title,
                  const std::string& note, const DrawingOptions& options);

}  // namespace forge
