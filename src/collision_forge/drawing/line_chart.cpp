#include "collision_forge/drawing/line_chart.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "collision_forge/drawing/canvas.h"
#include "collision_forge/drawing/chart_legend.h"
#include "collision_forge/drawing/decimal_text.h"
#include "collision_forge/files/aside_file.h"

namespace forge {
namespace {

struct Range {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// Of the finite values, a little wider; one value alone has room about it.
Range rangeOf(const LineChart& chart) {
  Range range;
  for (const LineSeries& series : chart.series) {
    for (const double value : series.values) {
      if (!std::isfinite(value)) continue;
      range.low = std::min(range.low, value);
      range.high = std::max(range.high, value);
    }
  }
  const double margin = std::max(0.05 * (range.high - range.low), 1e-3);
  return {range.low - margin, range.high + margin};
}

/// Paints one chart; lengths in fonts are multiples of the font's size.
class ChartPainter {
 public:
  ChartPainter(Image& image, const LineChart& chart, const Range& range,
               const DrawingOptions& options)
      : chart_(chart),
        range_(range),
        options_(options),
        font_(options.png_font_size),
        canvas_(image) {
    area_ = {5.0 * font_, 4.5 * font_, image.width() - 7.0 * font_, image.height() - 8.0 * font_};
    for (const LineSeries& series : chart.series) {
      count_ = std::max(count_, static_cast<double>(series.values.size()));
    }
  }

  void paint() {
    const TextStyle style{options_.text_color, 1.2 * font_, true, TextAlign::kLeft};
    canvas_.text({font_, 1.8 * font_},
                 canvas_.fitted(chart_.title, area_.x + area_.width - font_, style), style);
    paintAxes();
    for (const LineSeries& series : chart_.series) paintSeries(series);
    paintChartLegend(chart_.series, area_.x, font_, options_, canvas_);
  }

 private:
  Vector2 at(double counted, double value) const {
    const double right = count_ > 1.0 ? (counted - 1.0) / (count_ - 1.0) : 0.5;
    const double up = (value - range_.low) / (range_.high - range_.low);
    return {area_.x + right * area_.width, area_.y + (1.0 - up) * area_.height};
  }

  void paintAxes() {
    constexpr int kLines = 4;
    const TextStyle right{options_.muted_text_color, font_, false, TextAlign::kRight};
    const TextStyle middle{options_.muted_text_color, font_, false, TextAlign::kCenter};
    for (int i = 0; i <= kLines; ++i) {
      const double value = range_.low + (range_.high - range_.low) * i / kLines;
      canvas_.stroke({at(1.0, value), at(count_, value)},
                     {options_.connector_color, i == 0 ? 2.0 : 1.0});
      canvas_.text(Vector2(area_.x - 0.5 * font_, at(1.0, value).y() + 0.35 * font_),
                   decimalText(value, 2), right);
    }
    for (const double counted : {1.0, count_}) {
      canvas_.text(at(counted, range_.low) + Vector2(0.0, 1.3 * font_), decimalText(counted, 0),
                   middle);
    }
    canvas_.text(Vector2(area_.x + 0.5 * area_.width, area_.y + area_.height + 2.6 * font_),
                 chart_.across, {options_.text_color, font_, false, TextAlign::kCenter});
  }

  void paintSeries(const LineSeries& series) {
    std::vector<Vector2> line;
    for (std::size_t i = 0; i < series.values.size(); ++i) {
      if (!std::isfinite(series.values[i])) continue;
      line.push_back(at(static_cast<double>(i + 1), series.values[i]));
    }
    canvas_.stroke(line, {series.color, 2.0});
    for (const Vector2& place : line) canvas_.fillCircle(place, 0.2 * font_, series.color);
  }

  const LineChart& chart_;
  const Range& range_;
  const DrawingOptions& options_;
  double font_;
  double count_ = 1.0;
  Canvas canvas_;
  PixelRect area_;
};

}  // namespace

void drawLineChart(const std::string& path, const LineChart& chart, const DrawingOptions& options) {
  const Range range = rangeOf(chart);
  if (!(range.low < range.high)) {
    throw std::invalid_argument("the chart \"" + chart.title + "\" has nothing to show");
  }
  Image image(options.chart_width, options.chart_height, options.background_color);
  ChartPainter(image, chart, range, options).paint();
  AsideFile file(path);
  image.writePng(file.stream());
  file.commit();
}

}  // namespace forge
