#pragma once

#include <optional>
#include <string>
#include <vector>

#include "collision_forge/drawing/options.h"

namespace forge {

/// A share in [0, 1] with its interval; without one `low` and `high` are `value`.
struct Bar {
  double value = 0.0;
  double low = 0.0;
  double high = 0.0;
};

/// Bars side by side in every group, one a series; an empty one leaves its place free.
struct BarSeries {
  std::string name;
  Color color;
  std::vector<std::optional<Bar>> bars;  ///< one a group
};

struct BarChart {
  std::string title;
  std::vector<std::string> groups;
  std::vector<BarSeries> series;
};

/// Draws a chart in percent, 0 to 100, intervals as whiskers, the legend below the title. The PNG
/// is written aside and renamed. Throws std::invalid_argument for a chart without groups or series
/// and for a series whose bars are not one a group, std::runtime_error naming `path`.
void drawBarChart(const std::string& path, const BarChart& chart, const DrawingOptions& options);

}  // namespace forge
