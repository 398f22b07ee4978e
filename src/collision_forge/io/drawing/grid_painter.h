#pragma once

#include <memory>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/close_up_inset.h"
#include "collision_forge/io/drawing/grid_layout.h"
#include "collision_forge/io/drawing/grid_texts.h"
#include "collision_forge/io/drawing/legend_rows.h"
#include "collision_forge/io/drawing/scenario_grid.h"
#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

/// Paints a grid of scenarios at any time. Static parts are painted once, by the constructor. The
/// grid, with at least one row and one column, and the options must outlive it.
class GridPainter {
 public:
  /// `font_size` in pixels. Throws std::invalid_argument if it is not positive.
  GridPainter(const ScenarioGrid& grid, const DrawingOptions& options, double font_size,
              PictureKind kind);

  /// Paints every cell at its contact, with ghosts of ego and attacker from t0 on.
  Image paintContacts() const;
  /// Paints every cell `seconds` after t0, at most at its row's end.
  Image paint(double seconds) const;

  /// Returns the time from t0 to the latest end of a row, s.
  double end() const;

  /// Returns the mapping from ground to pixels of a cell.
  const Viewport& viewport(std::size_t row, std::size_t column) const {
    return cells_[row][column].viewport;
  }

 private:
  struct Cell {
    std::unique_ptr<const ScenePainter> scene;
    Viewport viewport;
    std::unique_ptr<const CloseUpInset> close_up;  ///< null if the cell has none
  };
  using LegendLines = std::vector<std::vector<LegendRow>>;

  TextStyle style(const Color& color, bool bold, TextAlign align) const;
  GridMeasures measure() const;
  double labelWidth(Canvas& canvas) const;
  double textWidth(Canvas& canvas) const;
  void placeCells();
  void addCloseUps(std::vector<Cell>& cells, const std::vector<Vector2>& shown) const;
  void paintBackground();
  void paintRowLabel(Canvas& canvas, const GridRowTexts& texts, const PixelRect& area) const;
  template <typename Holds>
  bool hasCell(const Holds& holds) const;
  LegendLines legendLines(Canvas& canvas, double width) const;
  LegendLines evenLegendLines(Canvas& canvas) const;
  void paintLegendLines(Canvas& canvas) const;
  double legendWidth(Canvas& canvas, const LegendRow& row) const;
  void paintCell(Canvas& canvas, std::size_t row, std::size_t column, double time,
                 double ghosts_from) const;
  void paintOutcome(Canvas& canvas, std::size_t row, std::size_t column) const;

  const ScenarioGrid& grid_;
  const DrawingOptions& options_;
  double font_;
  PictureKind kind_;
  std::vector<GridRowTexts> texts_;  ///< one per row
  std::vector<double> ends_;         ///< end of each row, s from t0
  GridLayout layout_;
  std::vector<std::vector<Cell>> cells_;
  Image background_;
};

}  // namespace forge
