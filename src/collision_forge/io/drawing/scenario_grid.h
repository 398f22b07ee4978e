#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/scenario_view.h"

namespace forge {

/// One scenario of a grid. Its pattern holds the requested type and time; the pattern's boxes are
/// not drawn, as not every method has any.
struct GridCell {
  ScenarioView view;
  /// Reason why there is no attack; "" if there is one. Without an attack, the trajectory has an
  /// attacker's id and no points, and all agents are drawn as recorded.
  std::string refusal;
};

/// Scenarios side by side, to compare methods: one row per request, one column per method.
struct ScenarioGrid {
  std::vector<std::string> columns;         ///< names above the columns
  std::vector<std::vector<GridCell>> rows;  ///< per row one cell per column, all of one request
};

}  // namespace forge
