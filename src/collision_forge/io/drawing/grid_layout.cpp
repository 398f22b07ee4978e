#include "collision_forge/io/drawing/grid_layout.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "collision_forge/base/scene/number_words.h"

namespace forge {
namespace {

// Multiples of the font's size.
constexpr double kCellWidth = 25.0;
constexpr double kCellHeight = 19.0;
constexpr double kNameHeight = 2.2;
constexpr double kCaptionHeight = 1.9;
constexpr double kLabelGap = 1.2;
constexpr double kColumnGap = 0.9;
constexpr double kRowGap = 0.8;
constexpr double kAboveLegend = 0.5;
constexpr double kPadding = 1.0;
constexpr double kTextMargin = 0.5;  // on each side of a cell's widest text

}  // namespace

GridLayout layoutGrid(const GridMeasures& measures) {
  const double font = measures.font_size;
  if (font <= 0) {
    throw std::invalid_argument("font size must be above 0, is " + numberText(font));
  }
  GridLayout layout;
  const auto pixels = [font](double fonts) { return std::round(fonts * font); };
  layout.padding = pixels(kPadding);
  const double width =
      std::max(pixels(kCellWidth), std::ceil(measures.text_width + 2 * kTextMargin * font));
  const double left = layout.padding + std::ceil(measures.label_width) + pixels(kLabelGap);
  layout.corner = {layout.padding, layout.padding, measures.label_width, pixels(kNameHeight)};
  double x = left;
  for (std::size_t column = 0; column < measures.columns; ++column) {
    layout.names.push_back({x, layout.padding, width, pixels(kNameHeight)});
    x += width + pixels(kColumnGap);
  }
  double y = layout.padding + pixels(kNameHeight);
  for (std::size_t row = 0; row < measures.rows; ++row) {
    layout.labels.push_back({layout.padding, y, measures.label_width, pixels(kCellHeight)});
    layout.cells.emplace_back();
    layout.captions.emplace_back();
    for (const PixelRect& name : layout.names) {
      layout.cells.back().push_back({name.x, y, width, pixels(kCellHeight)});
      layout.captions.back().push_back(
          {name.x, y + pixels(kCellHeight), width, pixels(kCaptionHeight)});
    }
    y += pixels(kCellHeight) + pixels(kCaptionHeight) + pixels(kRowGap);
  }
  layout.legend = {layout.padding, y + pixels(kAboveLegend),
                   x - pixels(kColumnGap) - layout.padding, 0.0};
  return layout;
}

}  // namespace forge
