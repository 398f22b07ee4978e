#pragma once

#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/canvas.h"
#include "collision_forge/io/drawing/caption_painter.h"

namespace forge {

/// Width of a mark of the legend, and of the gap before its meaning; multiples of the font's size.
inline constexpr double kLegendMark = 2.0;
inline constexpr double kLegendGap = 0.6;

/// One line of the legend: a mark drawn around the given pixel, and what it means.
struct LegendRow {
  std::function<void(const Vector2&)> paint_mark;
  std::string meaning;
  bool is_of_pattern = false;  ///< of what was asked for, not of what is driven
};

/// What the pictures beside a legend have.
struct LegendContents {
  PictureKind kind = PictureKind::kStill;
  bool has_contact = false;
  bool has_rest = false;  ///< rest positions after a contact
};

/// All of them, from top to bottom. The canvas and the options must outlive them.
std::vector<LegendRow> legendRows(Canvas& canvas, double font, const LegendContents& contents,
                                  const DrawingOptions& options);

}  // namespace forge
