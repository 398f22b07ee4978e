#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/caption_text.h"
#include "collision_forge/io/drawing/scenario_grid.h"

namespace forge {

/// Beside a row and under its cells.
struct GridRowTexts {
  std::vector<std::string> title;  ///< the type, in short lines
  std::string time;                ///< as "after 4.0 s"
  std::string scene;
  std::vector<OutcomeText> outcomes;  ///< one a cell; of one without an attack why it has none
};

GridRowTexts gridRowTexts(const std::vector<GridCell>& row);

/// Words in lines of at most so many letters; a longer word is a line of its own.
std::vector<std::string> inLines(const std::string& text, std::size_t letters);

}  // namespace forge
