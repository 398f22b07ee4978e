#include "collision_forge/drawing/reliability_plot.h"

#include <stdexcept>

#include "collision_forge/drawing/canvas.h"
#include "collision_forge/drawing/chart_legend.h"
#include "collision_forge/files/aside_file.h"

namespace forge {
namespace {

/// Paints one plot; lengths in fonts are multiples of the font's size.
class PlotPainter {
 public:
  PlotPainter(Image& image, const ReliabilityPlot& plot, const DrawingOptions& options)
      : plot_(plot), options_(options), font_(options.png_font_size), canvas_(image) {
    const double side = image.height() - 7.5 * font_;
    area_ = {4.5 * font_, 4.5 * font_, side, side};
  }

  void paint() {
    const TextStyle style{options_.text_color, 1.2 * font_, true, TextAlign::kLeft};
    canvas_.text({font_, 1.8 * font_},
                 canvas_.fitted(plot_.title, 2.0 * area_.x + area_.width, style), style);
    paintAxes();
    canvas_.stroke({at(0.0, 0.0), at(1.0, 1.0)},
                   {options_.muted_text_color, 1.0, 1.0, 0.5 * font_});
    for (const ReliabilitySeries& series : plot_.series) paintSeries(series);
    paintChartLegend(plot_.series, area_.x, font_, options_, canvas_);
  }

 private:
  Vector2 at(double promised, double kept) const {
    return {area_.x + promised * area_.width, area_.y + (1.0 - kept) * area_.height};
  }

  void paintAxes() {
    constexpr int kStep = 20;  // percent between two lines
    for (int percent = 0; percent <= 100; percent += kStep) {
      const double share = percent / 100.0;
      const LineStyle line{options_.connector_color, percent == 0 ? 2.0 : 1.0};
      canvas_.stroke({at(0.0, share), at(1.0, share)}, line);
      canvas_.stroke({at(share, 0.0), at(share, 1.0)}, line);
      const std::string text = std::to_string(percent) + " %";
      canvas_.text(at(0.0, share) + Vector2(-0.5 * font_, 0.35 * font_), text,
                   {options_.muted_text_color, font_, false, TextAlign::kRight});
      canvas_.text(at(share, 0.0) + Vector2(0.0, 1.3 * font_), text,
                   {options_.muted_text_color, font_, false, TextAlign::kCenter});
    }
    canvas_.text(at(0.5, 0.0) + Vector2(0.0, 2.6 * font_), "promised (kept upwards)",
                 {options_.text_color, font_, false, TextAlign::kCenter});
  }

  void paintSeries(const ReliabilitySeries& series) {
    std::vector<Vector2> line;
    for (const ReliabilityPoint& point : series.points) {
      line.push_back(at(point.promised, point.kept.value));
      canvas_.stroke({at(point.promised, point.kept.low), at(point.promised, point.kept.high)},
                     {series.color, 2.0});
    }
    canvas_.stroke(line, {series.color, 2.0});
    for (const Vector2& place : line) canvas_.fillCircle(place, 0.3 * font_, series.color);
  }

  const ReliabilityPlot& plot_;
  const DrawingOptions& options_;
  double font_;
  Canvas canvas_;
  PixelRect area_;
};

}  // namespace

void drawReliabilityPlot(const std::string& path, const ReliabilityPlot& plot,
                         const DrawingOptions& options) {
  if (plot.series.empty()) {
    throw std::invalid_argument("the plot \"" + plot.title + "\" has nothing to show");
  }
  Image image(options.plot_size, options.plot_size, options.background_color);
  PlotPainter(image, plot, options).paint();
  AsideFile file(path);
  image.writePng(file.stream());
  file.commit();
}

}  // namespace forge
