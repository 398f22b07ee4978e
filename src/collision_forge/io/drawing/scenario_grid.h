#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/animation.h"
#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// One scenario among others. Its pattern's type and time say what was asked for; the boxes of the
/// pattern are not shown, as not every method has one.
struct GridCell {
  ScenarioView view;
  /// Why there is no attack; empty: there is one. Without one the trajectory has an attacker's id
  /// and no points, and everybody is drawn as recorded.
  std::string refusal;
};

/// Scenarios side by side: how several methods answer one request, a row a request.
struct ScenarioGrid {
  std::vector<std::string> columns;         ///< what stands over them
  std::vector<std::vector<GridCell>> rows;  ///< a cell a column; all of one request
};

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
