#include "collision_forge/io/drawing/figure_layout.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "collision_forge/base/scene/number_words.h"

namespace forge {

FigureSize pngSize(const DrawingOptions& options) {
  return {options.png_width, options.png_height, options.png_font_size};
}

FigureSize gifSize(const DrawingOptions& options) {
  return {options.gif_width, options.gif_height, options.gif_font_size};
}

FigureLayout layoutFigure(const FigureSize& size) {
  FigureLayout layout;
  const double font = size.font_size;
  const double line = 1.45 * font;
  const double pad = 0.9 * font;
  layout.line_height = line;
  layout.padding = pad;
  const double header_height = 3.9 * font;
  const double footer_height = (kCaptionRows + 1) * line + 1.6 * pad;
  const double map_height = size.height - header_height - footer_height;
  if (font <= 0 || map_height < 0.3 * size.height || size.width < 30 * font) {
    throw std::invalid_argument("picture is too small: " + std::to_string(size.width) + " x " +
                                std::to_string(size.height) + " pixels with a font of " +
                                numberText(font));
  }
  const double width = size.width;
  layout.header = {pad, 0, width - 2 * pad, header_height};
  layout.map = {0, header_height, width, map_height};
  const double top = header_height + map_height + 0.7 * pad;
  const double square = std::min(footer_height - line - 1.6 * pad, 0.23 * width);
  const double text_width = width - square - 5 * pad;
  layout.legend = {pad, top, 0.35 * text_width, footer_height};
  layout.report = {layout.legend.x + layout.legend.width + 1.5 * pad, top, 0.65 * text_width,
                   footer_height};
  layout.close_up = {width - pad - square, top + line + 0.2 * pad, square, square};
  return layout;
}

FigureLayout withMapHeight(FigureLayout layout, double height) {
  const double removed = layout.map.height - height;
  layout.map.height = height;
  for (PixelRect* below : {&layout.legend, &layout.report, &layout.close_up}) below->y -= removed;
  return layout;
}

}  // namespace forge
