#pragma once

#include "collision_forge/io/drawing/options.h"
#include "collision_forge/io/drawing/viewport.h"

namespace forge {

/// Size of a whole picture and of its text, pixels.
struct FigureSize {
  int width = 0;
  int height = 0;  ///< at most; the picture is less high if its map is cropped
  double font_size = 0.0;
};

/// Returns the size of stills, with the greatest height.
FigureSize pngSize(const DrawingOptions& options);
/// Returns the size of animations, with the greatest height.
FigureSize gifSize(const DrawingOptions& options);

/// Areas of a picture, pixels: title above, the map, and three columns below. Texts never cover the
/// map.
struct FigureLayout {
  PixelRect header;          ///< title, details, verdict and clock
  PixelRect map;             ///< the map, over the whole width
  PixelRect legend;          ///< left column, with its title
  PixelRect report;          ///< middle column, with its title
  PixelRect close_up;        ///< right column: a square below the column's title
  double line_height = 0.0;  ///< distance of baselines of the text below the map
  double padding = 0.0;      ///< between areas and around texts
};

/// Lines of text below the title of the legend and of the report.
inline constexpr int kCaptionRows = 16;

/// Returns the layout of the highest picture of that size. Throws std::invalid_argument if the font
/// is not positive or too large: the map would have less than 30 % of the height, or the width is
/// less than 30 font sizes.
FigureLayout layoutFigure(const FigureSize& size);

/// Returns the layout with a map of `height` pixels, at most the former height; areas below move
/// up.
FigureLayout withMapHeight(FigureLayout layout, double height);

}  // namespace forge
