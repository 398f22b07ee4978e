#pragma once

#include <string>

#include "collision_forge/io/drawing/animation.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_grid.h"

namespace forge {

/// Draws every cell as drawScenarioPng(), the cells of a row at one scale. Type, time and scene are
/// beside a row, the outcome of the attack under each cell.
///
/// Both functions write with drawAside(); the same input gives the same bytes on the same machine.
/// They throw std::invalid_argument for a grid without rows or columns and for a row whose number
/// of cells is not the number of columns, std::runtime_error naming `path` as drawScenarioPng().
void drawScenarioGridPng(const std::string& path, const ScenarioGrid& grid,
                         const DrawingOptions& options);

/// Animates all cells synchronously in a loop, from t0 to the latest ScenarioMotion::endTime(). A
/// row that ends earlier holds its last frame. The outcome of an attack appears at its contact.
void drawScenarioGridGif(const std::string& path, const ScenarioGrid& grid,
                         const DrawingOptions& options, const PictureProgress& on_progress = {});

}  // namespace forge
