#include "collision_forge/io/drawing/grid_painter.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "collision_forge/io/drawing/decimal_text.h"

namespace forge {
namespace {

constexpr double kTimeTolerance = 1e-6;  // s

// Multiples of the font's size.
constexpr double kMarkSize = 0.75;  // lines and marks in a cell
constexpr double kLineHeight = 1.45;
constexpr double kLegendLineHeight = 1.8;
constexpr double kLegendSpace = 1.6;  // between two entries of a legend line
constexpr double kCloseUpGap = 0.4;   // between a close-up and the cell's edges

constexpr double kCloseUpSide = 0.42;  // share of a cell's height
constexpr double kCloseUpBelow = 0.3;  // pixels per m, per pixel of the font; below it vehicles are
                                       // too small, so a close-up is added

/// Returns the baseline of a line of text in the middle of an area.
double middleBaseline(const PixelRect& area, double font) {
  return area.center().y() + 0.36 * font;
}

constexpr const char* kVerdictMark = " · ";

std::string captionOf(const OutcomeText& outcome) {
  return outcome.verdict.empty() ? outcome.contact
                                 : outcome.contact + kVerdictMark + outcome.verdict;
}

std::vector<GridRowTexts> textsOf(const ScenarioGrid& grid) {
  std::vector<GridRowTexts> texts;
  for (const auto& row : grid.rows) texts.push_back(gridRowTexts(row));
  return texts;
}

/// Returns the end of a row's animation, s from t0: the latest end of a cell, or the time until
/// which the motion of all vehicles is known.
double endOf(const std::vector<GridCell>& row) {
  double end = 0.0;
  double known = std::numeric_limits<double>::infinity();
  for (const GridCell& cell : row) {
    const ScenarioView& view = cell.view;
    const double now = view.snapshot.now;
    end = std::max(end, ScenarioMotion(view).endTime() - now);
    if (hasRest(view)) continue;
    known = std::min(known, view.future.ego.states.back().time - now);
    if (!view.report.contact && cell.refusal.empty()) {
      known = std::min(known, view.trajectory.points.back().time - now);
    }
  }
  return std::min(end, known);
}

std::vector<double> endsOf(const ScenarioGrid& grid) {
  std::vector<double> ends;
  for (const auto& row : grid.rows) ends.push_back(endOf(row));
  return ends;
}

/// Returns the baseline of one of several lines.
double baselineOf(std::size_t line, std::size_t lines, const PixelRect& area, double font) {
  const double middle = 0.5 * static_cast<double>(lines - 1);
  return middleBaseline(area, font) + (static_cast<double>(line) - middle) * kLineHeight * font;
}

}  // namespace

GridPainter::GridPainter(const ScenarioGrid& grid, const DrawingOptions& options, double font_size,
                         PictureKind kind)
    : grid_(grid),
      options_(options),
      font_(font_size),
      kind_(kind),
      texts_(textsOf(grid)),
      ends_(endsOf(grid)),
      layout_(layoutGrid(measure())),
      background_(1, 1, options.background_color) {
  placeCells();
  paintBackground();
}

TextStyle GridPainter::style(const Color& color, bool bold, TextAlign align) const {
  return {color, font_, bold, align};
}

GridMeasures GridPainter::measure() const {
  Image none(1, 1, options_.background_color);
  Canvas canvas(none);
  return {grid_.rows.size(), grid_.columns.size(), font_, labelWidth(canvas), textWidth(canvas)};
}

double GridPainter::labelWidth(Canvas& canvas) const {
  const TextStyle bold = style(options_.text_color, true, TextAlign::kLeft);
  const TextStyle plain = style(options_.text_color, false, TextAlign::kLeft);
  double width = 0.0;
  if (kind_ == PictureKind::kAnimation) {
    const int digits = end() >= 10.0 ? 2 : 1;
    width = canvas.textWidth("t = +" + std::string(static_cast<std::size_t>(digits), '0') + ".0 s",
                             bold);
  }
  for (const GridRowTexts& row : texts_) {
    for (const std::string& line : row.title) width = std::max(width, canvas.textWidth(line, bold));
    width =
        std::max({width, canvas.textWidth(row.time, plain), canvas.textWidth(row.scene, plain)});
  }
  return width;
}

double GridPainter::textWidth(Canvas& canvas) const {
  const TextStyle bold = style(options_.text_color, true, TextAlign::kLeft);
  double width = 0.0;
  for (const std::string& name : grid_.columns) {
    width = std::max(width, canvas.textWidth(name, bold));
  }
  for (const GridRowTexts& row : texts_) {
    for (const OutcomeText& outcome : row.outcomes) {
      width = std::max(width, canvas.textWidth(captionOf(outcome), style(options_.text_color, false,
                                                                         TextAlign::kLeft)));
    }
  }
  return width;
}

void GridPainter::placeCells() {
  for (std::size_t row = 0; row < grid_.rows.size(); ++row) {
    std::vector<std::unique_ptr<const ScenePainter>> scenes;
    std::vector<Vector2> shown;
    for (const GridCell& cell : grid_.rows[row]) {
      scenes.push_back(std::make_unique<const ScenePainter>(cell.view, options_, kMarkSize * font_,
                                                            kind_, false));
      for (const Vector2& corner : scenes.back()->shownCorners(scenes.back()->motion().now())) {
        shown.push_back(corner);
      }
    }
    std::vector<Cell> cells;
    for (std::size_t column = 0; column < scenes.size(); ++column) {
      const Viewport viewport = fitViewport(layout_.cells[row][column], shown, options_.view_margin,
                                            options_.min_extent, scenes[column]->rightwards());
      cells.push_back({std::move(scenes[column]), viewport, nullptr});
    }
    addCloseUps(cells, shown);
    cells_.push_back(std::move(cells));
  }
}

/// Places close-ups in the same corner of all cells of a row that have a contact.
void GridPainter::addCloseUps(std::vector<Cell>& cells, const std::vector<Vector2>& shown) const {
  const Viewport& first = cells.front().viewport;
  if (first.pixelsPerMetre() >= kCloseUpBelow * font_) return;
  std::vector<Vector2> pixels;
  for (const Vector2& point : shown) pixels.push_back(first.toPixel(point));
  const double side = std::round(kCloseUpSide * first.area().height);
  const PixelRect corner = freeCorner(first.area(), side, std::round(kCloseUpGap * font_), pixels);
  for (Cell& cell : cells) {
    if (!cell.scene->hasContact()) continue;
    const PixelRect& area = cell.viewport.area();
    cell.close_up = std::make_unique<const CloseUpInset>(
        *cell.scene,
        PixelRect{corner.x + area.x - first.area().x, corner.y + area.y - first.area().y, side,
                  side},
        options_);
  }
}

void GridPainter::paintBackground() {
  Canvas scratch(background_);
  const LegendLines lines = evenLegendLines(scratch);
  const PixelRect& legend = layout_.legend;
  const double bottom =
      legend.y + static_cast<double>(lines.size()) * kLegendLineHeight * font_ + layout_.padding;
  background_ = Image(static_cast<int>(std::ceil(legend.x + legend.width + layout_.padding)),
                      static_cast<int>(std::ceil(bottom)), options_.background_color);
  Canvas canvas(background_);
  const TextStyle name_style = style(options_.text_color, true, TextAlign::kCenter);
  for (std::size_t column = 0; column < layout_.names.size(); ++column) {
    const PixelRect& area = layout_.names[column];
    canvas.text({area.center().x(), middleBaseline(area, font_)}, grid_.columns[column],
                name_style);
  }
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    paintRowLabel(canvas, texts_[row], layout_.labels[row]);
    for (const Cell& cell : cells_[row]) {
      canvas.clip(cell.viewport.area());
      cell.scene->paintGround(canvas, cell.viewport);
      canvas.unclip();
    }
  }
  paintLegendLines(canvas);
}

void GridPainter::paintRowLabel(Canvas& canvas, const GridRowTexts& texts,
                                const PixelRect& area) const {
  const std::size_t lines = texts.title.size() + 2;
  std::size_t line = 0;
  const auto write = [&](const std::string& text, const Color& color, bool bold) {
    canvas.text({area.x, baselineOf(line, lines, area, font_)}, text,
                style(color, bold, TextAlign::kLeft));
    ++line;
  };
  for (const std::string& part : texts.title) write(part, options_.text_color, true);
  write(texts.time, options_.text_color, false);
  write(texts.scene, options_.muted_text_color, false);
}

template <typename Holds>
bool GridPainter::hasCell(const Holds& holds) const {
  return std::any_of(grid_.rows.begin(), grid_.rows.end(), [&](const auto& row) {
    return std::any_of(row.begin(), row.end(),
                       [&](const GridCell& cell) { return holds(cell.view); });
  });
}

double GridPainter::legendWidth(Canvas& canvas, const LegendRow& row) const {
  return (kLegendMark + kLegendGap) * font_ +
         canvas.textWidth(row.meaning, style(options_.text_color, false, TextAlign::kLeft));
}

GridPainter::LegendLines GridPainter::legendLines(Canvas& canvas, double width) const {
  LegendLines lines;
  double left = 0.0;  // left over in the current line
  const LegendContents contents{kind_, hasCell(hasContact), hasCell(hasRest)};
  for (const LegendRow& row : legendRows(canvas, font_, contents, options_)) {
    if (row.is_of_pattern) continue;
    const double needed = legendWidth(canvas, row);
    if (lines.empty() || needed > left) {
      lines.emplace_back();
      left = width;
    }
    lines.back().push_back(row);
    left -= needed + kLegendSpace * font_;
  }
  return lines;
}

/// Returns as few lines as fit, of similar length.
GridPainter::LegendLines GridPainter::evenLegendLines(Canvas& canvas) const {
  const std::size_t fewest = legendLines(canvas, layout_.legend.width).size();
  double width = layout_.legend.width / static_cast<double>(fewest);
  while (legendLines(canvas, width).size() > fewest) width += font_;
  return legendLines(canvas, std::min(width, layout_.legend.width));
}

void GridPainter::paintLegendLines(Canvas& canvas) const {
  const TextStyle text_style = style(options_.text_color, false, TextAlign::kLeft);
  double baseline = layout_.legend.y + font_;
  for (const std::vector<LegendRow>& line : evenLegendLines(canvas)) {
    double width = kLegendSpace * font_ * static_cast<double>(line.size() - 1);
    for (const LegendRow& row : line) width += legendWidth(canvas, row);
    double x = layout_.legend.center().x() - width / 2;
    for (const LegendRow& row : line) {
      row.paint_mark({x + kLegendMark * font_ / 2, baseline - 0.36 * font_});
      canvas.text({x + (kLegendMark + kLegendGap) * font_, baseline}, row.meaning, text_style);
      x += legendWidth(canvas, row) + kLegendSpace * font_;
    }
    baseline += kLegendLineHeight * font_;
  }
}

double GridPainter::end() const { return *std::max_element(ends_.begin(), ends_.end()); }

Image GridPainter::paintContacts() const {
  Image image(background_);
  Canvas canvas(image);
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    for (std::size_t column = 0; column < cells_[row].size(); ++column) {
      const ScenarioMotion& motion = cells_[row][column].scene->motion();
      paintCell(canvas, row, column, motion.keyTime(), motion.now());
    }
  }
  return image;
}

Image GridPainter::paint(double seconds) const {
  Image image(background_);
  Canvas canvas(image);
  canvas.text({layout_.corner.x, middleBaseline(layout_.corner, font_)},
              "t = " + signedSeconds(seconds, 1),
              style(options_.text_color, true, TextAlign::kLeft));
  for (std::size_t row = 0; row < cells_.size(); ++row) {
    for (std::size_t column = 0; column < cells_[row].size(); ++column) {
      const double now = cells_[row][column].scene->motion().now();
      const double time = now + std::min(seconds, ends_[row]);
      paintCell(canvas, row, column, time, time);
    }
  }
  return image;
}

void GridPainter::paintCell(Canvas& canvas, std::size_t row, std::size_t column, double time,
                            double ghosts_from) const {
  const Cell& cell = cells_[row][column];
  const PixelRect& area = cell.viewport.area();
  canvas.clip(area);
  cell.scene->paint(canvas, cell.viewport, time, ghosts_from);
  if (column == 0) paintScale(canvas, cell.viewport, {0, 0, kMarkSize * font_}, options_);
  canvas.unclip();
  if (cell.close_up) cell.close_up->paint(canvas, time);
  canvas.stroke(edgeOf(area), {options_.lane_color, 1.0, 1.0, 0.0, true});
  const bool is_known = !grid_.rows[row][column].refusal.empty() ||
                        time >= cell.scene->motion().keyTime() - kTimeTolerance;
  if (is_known) paintOutcome(canvas, row, column);
}

void GridPainter::paintOutcome(Canvas& canvas, std::size_t row, std::size_t column) const {
  const OutcomeText& outcome = texts_[row].outcomes[column];
  const PixelRect& area = layout_.captions[row][column];
  const CollisionReport& report = grid_.rows[row][column].view.report;
  const TextStyle contact =
      style(report.contact ? options_.text_color : options_.failed_color, false, TextAlign::kLeft);
  const TextStyle verdict =
      style(colorOf(verdictOf(grid_.rows[row][column].view), options_), false, TextAlign::kLeft);
  const double baseline = middleBaseline(area, font_);
  const double left = area.center().x() - canvas.textWidth(captionOf(outcome), contact) / 2;
  canvas.text({left, baseline}, outcome.contact, contact);
  if (outcome.verdict.empty()) return;
  const double end = left + canvas.textWidth(outcome.contact, contact);
  const TextStyle mark = style(options_.muted_text_color, false, TextAlign::kLeft);
  canvas.text({end, baseline}, kVerdictMark, mark);
  canvas.text({end + canvas.textWidth(kVerdictMark, mark), baseline}, outcome.verdict, verdict);
}

}  // namespace forge
