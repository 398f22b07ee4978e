#pragma once

#include <string>

#include "collision_forge/io/drawing/animation.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_grid.h"

namespace forge {

/// Draws every cell as of drawScenarioPng(), the cells of a row at one scale. Beside a row stand
/// type, time and scene; under a cell what came of the attack.
///
/// Both functions write aside and rename; the same input gives the same bytes on the same machine.
/// They throw std::invalid_argument for a grid without rows or columns and for a row that has not a
/// cell a column, std::runtime_error naming `path` as drawScenarioPng() does.
void drawScenarioGridPng(const std::string& path, const ScenarioGrid& grid,
                         const DrawingOptions& options);

/// Draws all cells in step, in a loop, from now to the latest ScenarioMotion::endTime() of a cell.
/// A row that ends earlier shows its last instant from then on. The outcome of an attack appears at
/// its contact.
void drawScenarioGridGif(const std::string& path, const ScenarioGrid& grid,
                         const DrawingOptions& options, const PictureProgress& on_progress = {});

}  // namespace forge
