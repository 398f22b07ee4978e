#pragma once

#include "collision_forge/drawing/canvas.h"
#include "collision_forge/drawing/options.h"

namespace forge {

/// A square of its colour and the name of each series (members `color` and `name`), from `left` on
/// above a chart.
template <typename SeriesList>
void paintChartLegend(const SeriesList& list, double left, double font,
                      const DrawingOptions& options, Canvas& canvas) {
  const TextStyle style{options.text_color, font, false, TextAlign::kLeft};
  double x = left;
  for (const auto& series : list) {
    canvas.fillRect({x, 2.6 * font, font, font}, series.color);
    canvas.text({x + 1.4 * font, 3.5 * font}, series.name, style);
    x += 3.4 * font + canvas.textWidth(series.name, style);
  }
}

}  // namespace forge
