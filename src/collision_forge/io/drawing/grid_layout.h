#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// How much a grid of scenarios holds, and how wide its texts are; pixels.
struct GridMeasures {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double font_size = 0.0;
  double label_width = 0.0;  ///< of what stands beside the rows
  double text_width = 0.0;   ///< of what stands over or under a cell
};

/// Names over the columns, what a row is of on its left, and under each cell a line of text. Cells
/// are as wide as their texts need; no two parts overlap. All in whole pixels but for the label's
/// width.
struct GridLayout {
  PixelRect corner;                           ///< over the labels, beside the names
  std::vector<PixelRect> names;               ///< one a column
  std::vector<PixelRect> labels;              ///< one a row
  std::vector<std::vector<PixelRect>> cells;  ///< row by row, all of one size
  std::vector<std::vector<PixelRect>> captions;
  PixelRect legend;  ///< from here on down; its height is 0
  double padding = 0.0;
};

/// Throws std::invalid_argument for a font without size.
GridLayout layoutGrid(const GridMeasures& measures);

}  // namespace forge
