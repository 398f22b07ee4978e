#pragma once

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// Pixels of a whole picture and of its text.
struct FigureSize {
  int width = 0;
  int height = 0;
  double font_size = 0.0;
};

FigureSize pngSize(const DrawingOptions& options);
FigureSize gifSize(const DrawingOptions& options);

/// Title above, the map, and below it three columns: the texts never cover the map.
struct FigureLayout {
  PixelRect header;
  PixelRect map;
  PixelRect legend;
  PixelRect report;
  PixelRect close_up;  ///< the square below its column's title
  double line_height = 0.0;
  double padding = 0.0;
};

/// Lines of text below the title of the legend and of the report.
inline constexpr int kCaptionRows = 14;

/// The layout of the highest picture of that size. Throws std::invalid_argument when the font
/// leaves no room for the map.
FigureLayout layoutFigure(const FigureSize& size);

/// The same with a map of `height` pixels, at most as high as before; what is below moves up.
FigureLayout withMapHeight(FigureLayout layout, double height);

}  // namespace forge
