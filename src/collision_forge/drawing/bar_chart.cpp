#include "collision_forge/drawing/bar_chart.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/drawing/canvas.h"
#include "collision_forge/drawing/chart_legend.h"
#include "collision_forge/files/aside_file.h"

namespace forge {
namespace {

constexpr double kGroupShare = 0.8;  // of a group's width that its bars take

/// Paints one chart; lengths in fonts are multiples of the font's size.
class ChartPainter {
 public:
  ChartPainter(Image& image, const BarChart& chart, const DrawingOptions& options)
      : chart_(chart), options_(options), font_(options.png_font_size), canvas_(image) {
    area_ = {4.0 * font_, 4.5 * font_, image.width() - 5.0 * font_, image.height() - 7.0 * font_};
  }

  void paint() {
    const TextStyle style{options_.text_color, 1.2 * font_, true, TextAlign::kLeft};
    canvas_.text({font_, 1.8 * font_},
                 canvas_.fitted(chart_.title, 4.0 * font_ + area_.width, style), style);
    paintChartLegend(chart_.series, area_.x, font_, options_, canvas_);
    paintAxis();
    for (std::size_t group = 0; group < chart_.groups.size(); ++group) paintGroup(group);
  }

 private:
  double toY(double share) const { return area_.y + (1.0 - share) * area_.height; }

  void paintAxis() {
    constexpr int kStep = 20;  // percent between two lines
    for (int percent = 0; percent <= 100; percent += kStep) {
      const double y = toY(percent / 100.0);
      canvas_.stroke({{area_.x, y}, {area_.x + area_.width, y}},
                     {options_.connector_color, percent == 0 ? 2.0 : 1.0});
      canvas_.text({area_.x - 0.5 * font_, y + 0.35 * font_}, std::to_string(percent) + " %",
                   {options_.muted_text_color, font_, false, TextAlign::kRight});
    }
  }

  void paintGroup(std::size_t group) {
    const double width = area_.width / static_cast<double>(chart_.groups.size());
    const double left = area_.x + width * static_cast<double>(group);
    canvas_.text({left + 0.5 * width, area_.y + area_.height + 1.5 * font_}, chart_.groups[group],
                 {options_.text_color, font_, false, TextAlign::kCenter});
    const double bar_width = kGroupShare * width / static_cast<double>(chart_.series.size());
    double x = left + 0.5 * (1.0 - kGroupShare) * width;
    for (const BarSeries& series : chart_.series) {
      if (series.bars[group]) paintBar(*series.bars[group], series.color, x, bar_width);
      x += bar_width;
    }
  }

  void paintBar(const Bar& bar, const Color& color, double x, double width) {
    constexpr double kGap = 1.0;  // pixels between two bars
    const double top = toY(bar.value);
    canvas_.fillRect({x, top, width - kGap, toY(0.0) - top}, color);
    const double middle = x + 0.5 * (width - kGap);
    const double half = 0.2 * width;
    if (bar.low == bar.high) return;
    const LineStyle whisker{options_.text_color, 1.0};
    canvas_.stroke({{middle, toY(bar.low)}, {middle, toY(bar.high)}}, whisker);
    for (const double end : {bar.low, bar.high}) {
      canvas_.stroke({{middle - half, toY(end)}, {middle + half, toY(end)}}, whisker);
    }
  }

  const BarChart& chart_;
  const DrawingOptions& options_;
  double font_;
  Canvas canvas_;
  PixelRect area_;
};

}  // namespace

void drawBarChart(const std::string& path, const BarChart& chart, const DrawingOptions& options) {
  if (chart.groups.empty() || chart.series.empty()) {
    throw std::invalid_argument("the chart \"" + chart.title + "\" has nothing to show");
  }
  for (const BarSeries& series : chart.series) {
    if (series.bars.size() == chart.groups.size()) continue;
    throw std::invalid_argument("the series \"" + series.name + "\" has " +
                                std::to_string(series.bars.size()) + " bars for " +
                                std::to_string(chart.groups.size()) + " groups");
  }
  Image image(options.chart_width, options.chart_height, options.background_color);
  ChartPainter(image, chart, options).paint();
  AsideFile file(path);
  image.writePng(file.stream());
  file.commit();
}

}  // namespace forge
