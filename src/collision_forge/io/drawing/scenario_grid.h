#pragma once

#include <string>
#include <vector>

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

}  // namespace forge
