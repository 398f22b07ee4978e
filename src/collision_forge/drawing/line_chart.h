#pragma once

#include <string>
#include <vector>

#include "collision_forge/drawing/options.h"

namespace forge {

struct LineSeries {
  std::string name;
  Color color;
  std::vector<double> values;  ///< at 1, 2, 3 and so on
};

struct LineChart {
  std::string title;
  std::string across;  ///< what is counted to the right
  std::vector<LineSeries> series;
};

/// Draws lines over a common count, the value axis as far as the finite values reach, the legend
/// below the title. The PNG is written aside and renamed. Throws std::invalid_argument for a chart
/// without a finite value, std::runtime_error naming `path`.
void drawLineChart(const std::string& path, const LineChart& chart, const DrawingOptions& options);

}  // namespace forge
