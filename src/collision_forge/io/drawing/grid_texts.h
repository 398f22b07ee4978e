#pragma once

#include <string>
#include <vector>

#include "collision_forge/io/drawing/caption_text.h"
#include "collision_forge/io/drawing/scenario_grid.h"

namespace forge {

/// Texts beside a row and under its cells.
struct GridRowTexts {
  std::vector<std::string> title;  ///< the type, in short lines
  std::string time;                ///< as "after 4.0 s"
  std::string scene;
  std::vector<OutcomeText> outcomes;  ///< one per cell; without an attack, the reason
};

/// `row` must not be empty.
GridRowTexts gridRowTexts(const std::vector<GridCell>& row);

/// Splits text at spaces into lines of at most `letters` characters; a longer word gets its own
/// line.
std::vector<std::string> inLines(const std::string& text, std::size_t letters);

}  // namespace forge
