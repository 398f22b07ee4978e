#include "collision_forge/drawing/caption_painter.h"

#include "collision_forge/drawing/decimal_text.h"

namespace forge {

namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

std::string titleOf(CollisionType type) {
  switch (type) {
    case CollisionType::kLaneChange:
      return "Lane change";
    case CollisionType::kOppositeDirection:
      return "Opposite direction";
    case CollisionType::kRearEnd:
      return "Rear end";
    case CollisionType::kJunctionCrossing:
      return "Junction crossing";
    case CollisionType::kLtap:
      return "Left turn across path";
  }
  return toString(type);
}

struct ReportRow {
  std::string name;  ///< empty for a value that needs the whole line
  std::string value;
  Color color;
};

std::vector<ReportRow> reportRows(const ScenarioView& view, const DrawingOptions& options) {
  const CollisionReport& report = view.report;
  const double now = view.snapshot.now;
  const auto verdict = [&options](bool passed) {
    return passed ? options.passed_color : options.failed_color;
  };
  std::vector<ReportRow> rows;
  if (report.contact) {
    const std::string heading = decimalText(report.relative_heading * kDegreesPerRadian, 0) + "°";
    rows.push_back({"Contact",
                    signedSeconds(report.contact_time - now, 2) +
                        (report.on_time ? ", on time" : ", not on time"),
                    verdict(report.on_time)});
    rows.push_back({"Relative heading",
                    heading + (report.type_kept ? ", fits the type" : ", not of the type"),
                    verdict(report.type_kept)});
    rows.push_back(
        {"Sides",
         std::string(toString(report.attacker_side)) + " to ego's " + toString(report.ego_side),
         options.text_color});
    rows.push_back(
        {"Impact speed", decimalText(report.impact_speed, 1) + " m/s", options.text_color});
    rows.push_back(
        {"Overlap",
         decimalText(100 * report.overlap, 0) + " % of ego's " + toString(report.ego_side),
         options.text_color});
  } else {
    rows.push_back({"Contact", "none", options.failed_color});
  }
  if (view.contact_alone) return rows;
  if (report.contact) {
    rows.push_back({"Manoeuvre",
                    std::string(toString(report.manoeuvre)) + " from " +
                        signedSeconds(report.manoeuvre_begin - now, 1),
                    options.text_color});
  }
  rows.push_back({"Believable", report.believable() ? "yes" : "no: it " + report.unbelievable,
                  verdict(report.believable())});
  rows.push_back({"Limits kept", report.limits_kept ? "yes" : "no", verdict(report.limits_kept)});
  if (!report.broken_limit.empty()) {
    rows.push_back({"", report.broken_limit, options.failed_color});
  }
  const bool nobody = report.first_other_id.empty();
  rows.push_back(
      {"Touches first",
       nobody ? "nobody else"
              : signedSeconds(report.first_other_time - now, 1) + ", " + report.first_other_id,
       verdict(nobody)});
  rows.push_back(
      {"Off road", decimalText(100 * report.off_road_share, 0) + " %", options.text_color});
  rows.push_back({"Confidence", decimalText(report.confidence, 2), options.text_color});
  return rows;
}

TextStyle titleStyle(const FigureSize& size, const DrawingOptions& options) {
  return {options.text_color, size.font_size, true, TextAlign::kLeft};
}

}  // namespace

void paintHeader(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, const DrawingOptions& options) {
  const PixelRect& area = layout.header;
  const double font = size.font_size;
  const bool verified = view.report.verified();
  const TextStyle badge{verified ? options.passed_color : options.failed_color, font, true,
                        TextAlign::kRight};
  const std::string verdict = verified ? "verified" : "not verified";
  const double second_line = 3.1 * font;
  if (!view.contact_alone) canvas.text({area.x + area.width, second_line}, verdict, badge);

  const double room = area.width - canvas.textWidth("not verified", badge) - 2 * font;
  const TextStyle scene{options.text_color, 1.3 * font, true, TextAlign::kLeft};
  const TextStyle details{options.muted_text_color, font, false, TextAlign::kLeft};
  const std::string scene_title = titleOf(view.pattern.type) + " in " + view.scene_name;
  canvas.text({area.x, 1.7 * font}, canvas.fitted(scene_title, room, scene), scene);
  const std::string line = "TTA " + decimalText(view.tta, 1) + " s  ·  " + toString(view.mode) +
                           " mode  ·  attacker " + (view.trajectory.isAdded() ? "added, " : "") +
                           view.trajectory.attacker_id;
  canvas.text({area.x, second_line}, canvas.fitted(line, room, details), details);
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
  for (const ReportRow& row : reportRows(view, options)) {
    baseline += layout.line_height;
    canvas.text({area.x, baseline}, row.name, name_style);
    const TextStyle style{row.color, size.font_size, false, TextAlign::kLeft};
    const double x = row.name.empty() ? area.x + size.font_size : value_x;
    canvas.text({x, baseline}, canvas.fitted(row.value, area.x + area.width - x, style), style);
  }
}

void paintScale(Canvas& canvas, const Viewport& viewport, const FigureSize& size,
                const DrawingOptions& options) {
  const PixelRect& area = viewport.area();
  const double font = size.font_size;
  const double y = area.y + area.height - 0.9 * font;
  const double left = area.x + 0.9 * font;
  const double right = left + options.scale_bar * viewport.pixelsPerMetre();
  const double tick = 0.35 * font;
  const LineStyle line{options.text_color, 0.13 * font, 1.0, 0.0, false};
  canvas.stroke({{left, y - tick}, {left, y}, {right, y}, {right, y - tick}}, line);
  const TextStyle style{options.text_color, 0.9 * font, false, TextAlign::kCenter};
  canvas.text({(left + right) / 2, y - 0.5 * font}, decimalText(options.scale_bar, 0) + " m",
              style);

  const double arrow_x = area.x + area.width - 1.6 * font;
  canvas.fill({{{arrow_x, y - 2.4 * font},
                {arrow_x + 0.45 * font, y - 1.1 * font},
                {arrow_x, y - 1.4 * font},
                {arrow_x - 0.45 * font, y - 1.1 * font}}},
              options.text_color);
  canvas.text({arrow_x, y}, "N", style);
}

}  // namespace forge
