#pragma once

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// Size of a whole picture and of its text, pixels.
struct FigureSize {
  int width = 0;
  int height = 0;
  double font_size = 0.0;
};

/// Return the sizes of the options for stills and animations.
FigureSize pngSize(const DrawingOptions& options);
FigureSize gifSize(const DrawingOptions& options);

/// Areas of a picture, pixels: title above, the map, and three columns below. Texts never cover the
/// map.
struct FigureLayout {
  PixelRect header;
  PixelRect map;
  PixelRect legend;
  PixelRect report;
  PixelRect close_up;        ///< a square below its column's title
  double line_height = 0.0;  ///< of the text
  double padding = 0.0;      ///< between areas and around texts
};

/// Lines of text below the title of the legend and of the report.
inline constexpr int kCaptionRows = 16;

/// Returns the layout of the highest picture of that size. Throws std::invalid_argument if the font
/// is too large to leave space for the map.
FigureLayout layoutFigure(const FigureSize& size);

/// Returns the layout with a map of `height` pixels, at most the former height; areas below move
/// up.
FigureLayout withMapHeight(FigureLayout layout, double height);

}  // namespace forge
