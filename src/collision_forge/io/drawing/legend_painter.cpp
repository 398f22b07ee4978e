#include <functional>
#include <string>
#include <vector>

#include "collision_forge/io/drawing/box_painter.h"
#include "collision_forge/io/drawing/caption_painter.h"
#include "collision_forge/io/drawing/decimal_text.h"
#include "collision_forge/io/drawing/scene_painter.h"

namespace forge {

namespace {

// Width of a legend mark, and of the gap before its text; multiples of the font size.
constexpr double kLegendMark = 2.0;
constexpr double kLegendGap = 0.6;

/// One legend entry: a mark, drawn around the given pixel, and its meaning.
struct LegendRow {
  std::function<void(const Vector2&)> paint_mark;
  std::string meaning;
};

/// Returns the outline of a small vehicle that heads right.
std::vector<Vector2> markBox(const Vector2& center, double font) {
  const double half_length = 0.85 * font;
  const double half_width = 0.38 * font;
  return {center + Vector2(half_length, -half_width), center + Vector2(-half_length, -half_width),
          center + Vector2(-half_length, half_width), center + Vector2(half_length, half_width)};
}

/// Returns the legend entries from top to bottom. The canvas and the options must outlive them.
/// `font` in pixels.
std::vector<LegendRow> legendRows(Canvas& canvas, double font, const ScenarioView& view,
                                  PictureKind kind, const DrawingOptions& options) {
  const auto body = [&canvas, font](const Color& color, double opacity) {
    return [&canvas, font, color, opacity](const Vector2& center) {
      canvas.fill({markBox(center, font)}, color, opacity);
      canvas.stroke(markBox(center, font), {color, 0.08 * font, 1.0, 0.0, true});
    };
  };
  const auto outline = [&canvas, font](const Color& color) {
    return [&canvas, font, color](const Vector2& center) {
      canvas.stroke(markBox(center, font), {color, 0.16 * font, 1.0, 0.0, true});
    };
  };
  const auto line = [&canvas, &options, font](double dash) {
    return [&canvas, &options, font, dash](const Vector2& center) {
      const Vector2 half(1.0 * font, 0.0);
      canvas.stroke({center - half, center + half},
                    {options.muted_text_color, 0.18 * font, 1.0, dash, false});
    };
  };
  const auto star = [&canvas, &options, font](const Vector2& center) {
    paintStar(canvas, center, 0.7 * font, options.contact_color, options.text_color, 0.08 * font);
  };
  const bool is_still = kind == PictureKind::kStill;
  std::vector<LegendRow> rows = {
      {body(options.ego_color, 1.0), "Ego"},
      {body(options.attacker_color, 1.0), "Attacker"},
      {body(options.recorded_attacker_color, options.ghost_opacity), "Attacker as recorded"},
      {body(options.agent_color, 1.0),
       is_still && hasContact(view) ? "Agents at contact" : "Agents at time t"},
      {line(0.0), "Driven up to now"},
      {line(0.45 * font), "From now to contact"},
      {body(options.muted_text_color, options.ghost_opacity),
       "Every " + decimalText(options.ghost_interval, 1) + " s from now"},
      {outline(options.pattern_ego_color), "Pattern: ego"},
      {outline(options.pattern_attacker_color), "Pattern: attacker"},
      {star, "Contact"},
  };
  if (is_still) {
    rows.insert(rows.begin() + 4,
                {body(options.agent_color, options.ghost_opacity), "Agents when passed"});
  }
  if (!view.supports.empty()) {
    rows.insert(rows.begin() + 2, {body(options.support_color, 1.0), "Support vehicle"});
  }
  if (is_still && hasRest(view)) {
    rows.push_back({body(options.muted_text_color, kRestGhosts * options.ghost_opacity),
                    "At rest after the contact"});
  }
  return rows;
}

}  // namespace

void paintLegend(Canvas& canvas, const FigureLayout& layout, const FigureSize& size,
                 const ScenarioView& view, PictureKind kind, const DrawingOptions& options) {
  const double font = size.font_size;
  const PixelRect& area = layout.legend;
  double baseline = area.y + font;
  canvas.text({area.x, baseline}, "Legend", {options.text_color, font, true, TextAlign::kLeft});
  const TextStyle style{options.text_color, font, false, TextAlign::kLeft};
  for (const LegendRow& row : legendRows(canvas, font, view, kind, options)) {
    baseline += layout.line_height;
    row.paint_mark({area.x + kLegendMark * font / 2, baseline - 0.36 * font});
    const double left = (kLegendMark + kLegendGap) * font;
    canvas.text({area.x + left, baseline}, canvas.fitted(row.meaning, area.width - left, style),
                style);
  }
}

}  // namespace forge
