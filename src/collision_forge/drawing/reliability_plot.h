#pragma once

#include <string>
#include <vector>

#include "collision_forge/drawing/bar_chart.h"
#include "collision_forge/drawing/options.h"

namespace forge {

/// A share that was promised, in [0, 1], and the one that was kept.
struct ReliabilityPoint {
  double promised = 0.0;
  Bar kept;
};

struct ReliabilitySeries {
  std::string name;
  Color color;
  std::vector<ReliabilityPoint> points;  ///< joined in this order
};

struct ReliabilityPlot {
  std::string title;
  std::vector<ReliabilitySeries> series;
};

/// Draws promised to the right and kept upwards, both in percent from 0 to 100, with the diagonal
/// on which promises are kept, intervals as whiskers and the legend below the title; a square of
/// `plot_size`. The PNG is written aside and renamed. Throws std::invalid_argument for a plot
/// without series, std::runtime_error naming `path`.
void drawReliabilityPlot(const std::string& path, const ReliabilityPlot& plot,
                         const DrawingOptions& options);

}  // namespace forge
