#include "collision_forge/io/drawing/caption_painter.h"

#include "collision_forge/io/drawing/decimal_text.h"

namespace forge {

namespace {

// Light ground below scale bar and north arrow, in case a vehicle is below them.
constexpr double kScaleHeight = 2.6;  // multiples of the font's size
constexpr double kArrowWidth = 3.2;   // multiples of the font's size
constexpr double kScaleGround = 0.75;

Color colorOf(const CaptionRow& row, const DrawingOptions& options) {
  if (!row.passed) return options.text_color;
  return *row.passed ? options.passed_color : options.failed_color;
}

TextStyle titleStyle(const FigureSize& size, const DrawingOptions& options) {
  return {options.text_color, size.font_size, true, TextAlign::kLeft};
}

}  // namespace

Color colorOf(Verdict verdict, const DrawingOptions& options) {
  switch (verdict) {
    case Verdict::kWanted:
      return options.passed_color;
    case Verdict::kPartial:
      return options.partial_color;
    case Verdict::kUnwanted:
      return options.failed_color;
  }
  return options.text_color;
}

void paintHeader(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options) {
  const PixelRect& area = layout.header;
  const double font = size.font_size;
  const TextStyle badge{colorOf(verdictOf(view), options), font, true, TextAlign::kRight};
  const double first_line = 1.7 * font;
  const double second_line = 3.1 * font;
  // The clock is above the verdict.
  const TextStyle clock{options.text_color, 1.3 * font, true, TextAlign::kRight};
  const double clock_width = canvas.textWidth("t = +00.0 s", clock);
  const TextStyle scene{options.text_color, 1.3 * font, true, TextAlign::kLeft};
  canvas.text({area.x, first_line},
              canvas.fitted(titleText(view), area.width - clock_width - 2 * font, scene), scene);
  const std::string verdict = verdictText(view);
  canvas.text({area.x + area.width, second_line}, verdict, badge);
  const double room = area.width - canvas.textWidth(verdict, badge) - 2 * font;
  const TextStyle details{options.muted_text_color, font, false, TextAlign::kLeft};
  canvas.text({area.x, second_line}, canvas.fitted(detailsText(view), room, details), details);
}

void paintClock(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                const ScenarioView& view, const DrawingOptions& options, double time) {
  const TextStyle style{options.text_color, 1.3 * size.font_size, true, TextAlign::kRight};
  canvas.text({layout.header.x + layout.header.width, 1.7 * size.font_size},
              "t = " + signedSeconds(time - view.snapshot.now, 1), style);
}

void paintReport(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options) {
  const PixelRect& area = layout.report;
  double baseline = area.y + size.font_size;
  canvas.text({area.x, baseline}, "Report", titleStyle(size, options));
  const TextStyle name_style{options.muted_text_color, size.font_size, false, TextAlign::kLeft};
  const double value_x = area.x + canvas.textWidth("Relative heading", name_style) + size.font_size;
  for (const CaptionRow& row : reportRows(view)) {
    baseline += layout.line_height;
    canvas.text({area.x, baseline}, row.name, name_style);
    const TextStyle style{colorOf(row, options), size.font_size, false, TextAlign::kLeft};
    const double x = row.name.empty() ? area.x + size.font_size : value_x;
    canvas.text({x, baseline}, canvas.fitted(row.value, area.x + area.width - x, style), style);
  }
}

double scaleBarLength(const Viewport& viewport, double font, const DrawingOptions& options) {
  constexpr double kTextWidth = 3.0;  // multiples of the font's size
  for (const double factor : {1.0, 2.0, 5.0}) {
    const double length = factor * options.scale_bar;
    if (length * viewport.pixelsPerMetre() >= kTextWidth * font) return length;
  }
  return 10.0 * options.scale_bar;
}

void paintScale(Canvas& canvas, const Viewport& viewport, const FigureSize& size,
                const DrawingOptions& options) {
  const PixelRect& area = viewport.area();
  const double font = size.font_size;
  const double y = area.y + area.height - 0.9 * font;
  const double left = area.x + 0.9 * font;
  const double length = scaleBarLength(viewport, font, options);
  const double right = left + length * viewport.pixelsPerMetre();
  const double height = kScaleHeight * font - 1.0;  // pixels; leaves out the edge of the area
  const double top = area.y + area.height - 1.0 - height;
  canvas.fillRect({area.x, top, right + 0.9 * font - area.x, height}, options.background_color,
                  kScaleGround);
  canvas.fillRect({area.x + area.width - kArrowWidth * font, top, kArrowWidth * font, height},
                  options.background_color, kScaleGround);
  const double tick = 0.35 * font;
  const LineStyle line{options.text_color, 0.13 * font, 1.0, 0.0, false};
  canvas.stroke({{left, y - tick}, {left, y}, {right, y}, {right, y - tick}}, line);
  const TextStyle style{options.text_color, 0.9 * font, false, TextAlign::kCenter};
  canvas.text({(left + right) / 2, y - 0.5 * font}, decimalText(length, 0) + " m", style);

  const Vector2 arrow(area.x + area.width - 1.6 * font, y - 1.75 * font);
  const Vector2 middle = viewport.toWorld(area.center());
  const Vector2 north = (viewport.toPixel(middle + Vector2::UnitY()) - area.center()).normalized();
  const Vector2 east(-north.y(), north.x());
  const auto at = [&](double ahead, double aside) {
    return Vector2(arrow + font * (ahead * north + aside * east));
  };
  canvas.fill({{at(0.65, 0.0), at(-0.65, 0.45), at(-0.35, 0.0), at(-0.65, -0.45)}},
              options.text_color);
  canvas.text({arrow.x(), y}, "N", style);
}

}  // namespace forge
