#include "collision_forge/io/drawing/draw_grid.h"

#include <cmath>
#include <stdexcept>

#include "collision_forge/io/drawing/draw_aside.h"
#include "collision_forge/io/drawing/figure_layout.h"
#include "collision_forge/io/drawing/grid_painter.h"

namespace forge {
namespace {

constexpr double kTimeTolerance = 1e-6;  // s

void checkShape(const ScenarioGrid& grid) {
  if (grid.rows.empty() || grid.columns.empty()) {
    throw std::invalid_argument("scenario grid has no rows or no columns");
  }
  for (const std::vector<GridCell>& row : grid.rows) {
    if (row.size() == grid.columns.size()) continue;
    throw std::invalid_argument("row of " + std::to_string(row.size()) +
                                " scenarios in a grid of " + std::to_string(grid.columns.size()) +
                                " columns");
  }
}

void checkCells(const ScenarioGrid& grid, const DrawingOptions& options) {
  for (const std::vector<GridCell>& row : grid.rows) {
    for (const GridCell& cell : row) checkDrawable(cell.view, options, cell.refusal.empty());
  }
}

/// Returns evenly spaced frames from t0 to the end; the last one is held.
std::vector<AnimationFrame> planFrames(double end, const DrawingOptions& options) {
  const double rate = options.gif_frames_per_second;
  const auto last = static_cast<int>(std::ceil(end * rate - kTimeTolerance));
  std::vector<AnimationFrame> frames;
  for (int i = 0; i <= last; ++i) {
    const double seconds = 1.0 / rate + (i == last ? options.gif_contact_hold : 0.0);
    frames.push_back({i / rate, static_cast<int>(std::lround(100.0 * seconds))});
  }
  return frames;
}

}  // namespace

void drawScenarioGridPng(const std::string& path, const ScenarioGrid& grid,
                         const DrawingOptions& options) {
  checkShape(grid);
  drawAside(path, [&](std::ostream& file) {
    checkCells(grid, options);
    const GridPainter painter(grid, options, pngSize(options).font_size, PictureKind::kStill);
    painter.paintContacts().writePng(file);
  });
}

void drawScenarioGridGif(const std::string& path, const ScenarioGrid& grid,
                         const DrawingOptions& options, const PictureProgress& on_progress) {
  checkShape(grid);
  drawAside(path, [&](std::ostream& file) {
    checkCells(grid, options);
    const GridPainter painter(grid, options, gifSize(options).font_size, PictureKind::kAnimation);
    writeAnimation(
        file, planFrames(painter.end(), options),
        [&](double seconds) { return painter.paint(seconds); }, on_progress);
  });
}

}  // namespace forge
