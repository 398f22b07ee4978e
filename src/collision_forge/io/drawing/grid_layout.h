#pragma once

#include <cstddef>
#include <vector>

#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// Numbers of cells and widths of texts of a grid of scenarios; pixels.
struct GridMeasures {
  std::size_t rows = 0;
  std::size_t columns = 0;
  double font_size = 0.0;
  double label_width = 0.0;  ///< width of the row labels
  double text_width = 0.0;   ///< width of the texts above and below cells
};

/// Areas of a grid: names above the columns, a label left of each row, and a line of text under
/// each cell. Cells are as wide as their texts need; no two areas overlap. Whole pixels, except the
/// width of the labels.
struct GridLayout {
  PixelRect corner;                           ///< above the labels, beside the names
  std::vector<PixelRect> names;               ///< one per column
  std::vector<PixelRect> labels;              ///< one per row
  std::vector<std::vector<PixelRect>> cells;  ///< row by row, all of equal size
  std::vector<std::vector<PixelRect>> captions;
  PixelRect legend;  ///< top of the legend; its height is 0
  double padding = 0.0;
};

/// Returns the layout. Throws std::invalid_argument if the font size is not positive.
GridLayout layoutGrid(const GridMeasures& measures);

}  // namespace forge
