#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/caption_painter.h"

namespace forge {

/// Width of a legend mark, and of the gap before its text; multiples of the font size.
inline constexpr double kLegendMark = 2.0;
inline constexpr double kLegendGap = 0.6;

/// One legend entry: a mark, drawn around the given pixel, and its meaning.
struct LegendRow {
  std::function<void(const Vector2&)> paint_mark;
  std::string meaning;
  bool is_of_pattern = false;  ///< a mark of the predicted pattern, not of the motion
};

/// Contents of the pictures that a legend explains.
struct LegendContents {
  PictureKind kind = PictureKind::kStill;
  bool has_contact = false;
  bool has_rest = false;  ///< rest positions after a contact
};

/// Returns the legend entries from top to bottom. The canvas and the options must outlive them.
/// `font` in pixels.
std::vector<LegendRow> legendRows(Canvas& canvas, double font, const LegendContents& contents,
                                  const DrawingOptions& options);

}  // namespace forge
