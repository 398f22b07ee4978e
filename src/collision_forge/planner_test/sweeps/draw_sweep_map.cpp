#include "collision_forge/planner_test/sweeps/draw_sweep_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/base/scene/number_words.h"
#include "collision_forge/io/drawing/canvas.h"

namespace forge {
namespace {

constexpr std::size_t kColumns = 3;  // panels, and entries of the legend, side by side
constexpr double kMostTicks = 6.0;   // labels of a continuous axis

struct VerdictLook {
  SweepVerdict verdict;
  Color color;
  Color text;
  const char* words;
};
/// Colours of Okabe and Ito, which differ for people with colour blindness, too.
const VerdictLook kLooks[] = {
    {SweepVerdict::kAvoided, {0.34, 0.71, 0.91}, {0.05, 0.15, 0.25}, "avoided"},
    {SweepVerdict::kHit, {0.84, 0.37, 0.0}, {1.0, 1.0, 1.0}, "hit"},
    {SweepVerdict::kHitOther, {0.80, 0.47, 0.65}, {1.0, 1.0, 1.0}, "hit another agent"},
    {SweepVerdict::kFailed, {0.25, 0.25, 0.25}, {1.0, 1.0, 1.0}, "planner failed"},
    {SweepVerdict::kMixed, {0.94, 0.89, 0.26}, {0.2, 0.2, 0.0}, "mixed"},
    {SweepVerdict::kRejected, {0.91, 0.91, 0.92}, {0.5, 0.5, 0.5}, "no attack"},
};

const VerdictLook& lookOf(SweepVerdict verdict) {
  return *std::find_if(std::begin(kLooks), std::end(kLooks),
                       [&](const VerdictLook& look) { return look.verdict == verdict; });
}

/// A label of an axis.
struct AxisTick {
  double place = 0.0;
  std::string text;
};

/// Returns the labels of an axis; in an interval of numbers, round values: multiples of 1, 2 or 5
/// times a power of ten.
std::vector<AxisTick> ticksOf(const MapAxis& axis, bool is_grid) {
  std::vector<AxisTick> ticks;
  if (is_grid || axis.has_words) {
    for (std::size_t i = 0; i < axis.labels.size(); ++i) {
      ticks.push_back({is_grid ? static_cast<double>(i) : axis.values[i], axis.labels[i]});
    }
    return ticks;
  }
  const double least = std::max((axis.max - axis.min) / kMostTicks, 1e-9);
  const double power = std::pow(10.0, std::floor(std::log10(least)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0}) {
    if (factor * power >= least) step = factor * power;
  }
  for (double i = std::ceil(axis.min / step); i * step <= axis.max; ++i) {
    ticks.push_back({i * step, numberText(i * step)});
  }
  return ticks;
}

class SweepMapPainter {
 public:
  SweepMapPainter(const SweepMap& map, const DrawingOptions& options)
      : map_(map),
        options_(options),
        font_(options.png_font_size),
        width_(options.png_width),
        columns_(std::min(kColumns, map.panels.size())) {
    std::size_t longest = 0;
    for (const AxisTick& tick : ticksOf(map.y, map.is_grid)) {
      longest = std::max(longest, tick.text.size());
    }
    left_ = font_ * ((map.y.heading.empty() ? 1.0 : 2.5) + 0.5 * static_cast<double>(longest));
    const auto columns = static_cast<double>(std::max<std::size_t>(columns_, 2));
    plot_width_ = (width_ - left_ - font_ + kGap * font_) / columns - kGap * font_;
    const double tile = std::min(plot_width_ / static_cast<double>(map.x.labels.size()), 3 * font_);
    const double height = static_cast<double>(map.y.labels.size()) * tile;
    plot_height_ = map.is_grid ? std::clamp(height, 2.0 * font_, plot_width_) : 0.8 * plot_width_;
  }

  void paint(std::ostream& file, const std::string& title, const std::string& note) const {
    const double bottom = topOf(map_.panels.size() + columns_ - 1);
    const std::vector<VerdictLook> legend = legendEntries();
    const double rows = std::ceil(static_cast<double>(legend.size()) / kColumns);
    Image image(static_cast<int>(width_), static_cast<int>(bottom + (rows + 0.2) * 1.6 * font_),
                options_.background_color);
    Canvas canvas(image);
    const double room = width_ - 2.0 * font_;
    const TextStyle bold{options_.text_color, 1.15 * font_, true};
    const TextStyle small{options_.muted_text_color, 0.85 * font_};
    canvas.text({font_, 1.8 * font_}, canvas.fitted(title, room, bold), bold);
    canvas.text({font_, 3.2 * font_}, canvas.fitted(note, room, small), small);
    for (std::size_t i = 0; i < map_.panels.size(); ++i) paintPanel(canvas, i);
    for (std::size_t i = 0; i < legend.size(); ++i) {
      const double x = font_ + static_cast<double>(i % kColumns) * room / kColumns;
      const double y = bottom + static_cast<double>(i / kColumns) * 1.6 * font_;
      canvas.fillRect({x, y, font_, font_}, legend[i].color);
      canvas.text({x + 1.6 * font_, y + 0.85 * font_}, legend[i].words,
                  {options_.text_color, 0.85 * font_});
    }
    image.writePng(file);
  }

 private:
  static constexpr double kGap = 1.5;  // between panels, in sizes of the font

  double topOf(std::size_t panel) const {
    return 4.2 * font_ + static_cast<double>(panel / columns_) * (plot_height_ + 5.2 * font_);
  }

  /// Returns the middle of a place on the axes, in pixels.
  Vector2 pixelOf(const PixelRect& plot, double x, double y) const {
    const auto share = [&](const MapAxis& axis, double place) {
      if (map_.is_grid) return (place + 0.5) / static_cast<double>(axis.labels.size());
      const double span = axis.max - axis.min;
      return span > 0.0 ? 0.04 + 0.92 * (place - axis.min) / span : 0.5;
    };
    return {plot.x + share(map_.x, x) * plot.width,
            plot.y + plot.height - share(map_.y, y) * plot.height};
  }

  PixelRect tileAt(const PixelRect& plot, const MapTile& tile) const {
    const double width = plot.width / static_cast<double>(map_.x.labels.size());
    const double height = plot.height / static_cast<double>(map_.y.labels.size());
    const Vector2 middle = pixelOf(plot, tile.x, tile.y);
    return {middle.x() - width / 2, middle.y() - height / 2, width, height};
  }

  void paintPanel(Canvas& canvas, std::size_t index) const {
    const MapPanel& panel = map_.panels[index];
    const auto column = static_cast<double>(index % columns_);
    const PixelRect plot{left_ + column * (plot_width_ + kGap * font_), topOf(index) + 1.6 * font_,
                         plot_width_, plot_height_};
    const TextStyle title{options_.text_color, font_, true};
    const std::string name = panel.is_driver ? panel.name + " (careful driver)" : panel.name;
    canvas.text({plot.x, plot.y - 0.5 * font_}, canvas.fitted(name, plot.width, title), title);
    for (const MapTile& tile : panel.tiles) paintTile(canvas, plot, tile);
    if (map_.is_grid) paintBoundary(canvas, plot, panel);
    const double right = plot.x + plot.width;
    const double bottom = plot.y + plot.height;
    canvas.stroke({{plot.x, plot.y}, {right, plot.y}, {right, bottom}, {plot.x, bottom}},
                  {options_.muted_text_color, 1.0, 1.0, 0.0, true});
    paintHorizontalAxis(canvas, plot, index + columns_ >= map_.panels.size());
    if (index % columns_ == 0) paintVerticalAxis(canvas, plot);
  }

  void paintTile(Canvas& canvas, const PixelRect& plot, const MapTile& tile) const {
    const VerdictLook& look = lookOf(tile.verdict);
    if (!map_.is_grid) {
      const Vector2 middle = pixelOf(plot, tile.x, tile.y);
      canvas.fillCircle(middle, 0.35 * font_ + 1.0, options_.muted_text_color);
      canvas.fillCircle(middle, 0.35 * font_, look.color);
      return;
    }
    const PixelRect rect = tileAt(plot, tile);
    const PixelRect inner{rect.x + 0.5, rect.y + 0.5, rect.width - 1.0, rect.height - 1.0};
    canvas.fillRect(inner, look.color);
    if (tile.verdict == SweepVerdict::kRejected) {
      canvas.stroke({{inner.x, inner.y + inner.height}, {inner.x + inner.width, inner.y}},
                    {look.text, 1.0, 0.35});
    }
    const TextStyle style{look.text, 0.75 * font_, false, TextAlign::kCenter};
    if (canvas.textWidth(tile.text, style) > inner.width - 2.0 || style.size > inner.height) return;
    canvas.text({rect.center().x(), rect.center().y() + 0.35 * style.size}, tile.text, style);
  }

  /// Draws the edges between neighbours with an attack and different verdicts.
  void paintBoundary(Canvas& canvas, const PixelRect& plot, const MapPanel& panel) const {
    std::vector<std::vector<Vector2>> edges;
    for (const MapTile& a : panel.tiles) {
      for (const MapTile& b : panel.tiles) {
        const bool is_rejected =
            a.verdict == SweepVerdict::kRejected || b.verdict == SweepVerdict::kRejected;
        if (is_rejected || a.verdict == b.verdict) continue;
        const PixelRect rect = tileAt(plot, a);
        const Vector2 upper_right{rect.x + rect.width, rect.y};
        if (b.x - a.x == 1.0 && b.y == a.y) {
          edges.push_back({upper_right, {upper_right.x(), rect.y + rect.height}});
        } else if (b.y - a.y == 1.0 && b.x == a.x) {
          edges.push_back({{rect.x, rect.y}, upper_right});
        }
      }
    }
    for (const auto& edge : edges) canvas.stroke(edge, {options_.background_color, 5.0});
    for (const auto& edge : edges) canvas.stroke(edge, {options_.text_color, 2.5});
  }

  /// Leaves out a label that would cover the one before.
  void paintHorizontalAxis(Canvas& canvas, const PixelRect& plot, bool has_heading) const {
    TextStyle style{options_.muted_text_color, 0.8 * font_, false, TextAlign::kCenter};
    const double bottom = plot.y + plot.height;
    double end = -font_;
    for (const AxisTick& tick : ticksOf(map_.x, map_.is_grid)) {
      const double x = pixelOf(plot, tick.place, 0.0).x();
      const double half = 0.5 * canvas.textWidth(tick.text, style);
      if (x - half < end) continue;
      canvas.text({x, bottom + 1.1 * font_}, tick.text, style);
      end = x + half + 0.3 * font_;
    }
    style.color = options_.text_color;
    style.size = 0.9 * font_;
    if (has_heading) canvas.text({plot.center().x(), bottom + 2.5 * font_}, map_.x.heading, style);
  }

  void paintVerticalAxis(Canvas& canvas, const PixelRect& plot) const {
    const TextStyle style{options_.muted_text_color, 0.8 * font_, false, TextAlign::kRight};
    double end = plot.y + plot.height + font_;
    for (const AxisTick& tick : ticksOf(map_.y, map_.is_grid)) {
      const double y = pixelOf(plot, 0.0, tick.place).y() + 0.35 * style.size;
      if (y > end) continue;
      canvas.text({plot.x - 0.4 * font_, y}, tick.text, style);
      end = y - 1.1 * style.size;
    }
    canvas.text({1.4 * font_, plot.center().y()}, map_.y.heading,
                {options_.text_color, 0.9 * font_, false, TextAlign::kCenter, true});
  }

  /// Returns the looks of the verdicts in the map, then of the boundary.
  std::vector<VerdictLook> legendEntries() const {
    std::set<SweepVerdict> seen;
    bool has_counts = false;
    for (const MapPanel& panel : map_.panels) {
      for (const MapTile& tile : panel.tiles) {
        seen.insert(tile.verdict);
        has_counts = has_counts || tile.count > 1;
      }
    }
    std::vector<VerdictLook> entries;
    for (VerdictLook look : kLooks) {
      if (seen.count(look.verdict) == 0) continue;
      if (look.verdict == SweepVerdict::kHit && map_.is_grid) {
        look.words = has_counts ? "hit (numbers: hits of attacks)" : "hit (numbers: m/s at impact)";
      }
      entries.push_back(look);
    }
    if (map_.is_grid && entries.size() > 1) {
      entries.push_back(
          {SweepVerdict::kMixed, options_.text_color, {}, "line: the verdict changes"});
    }
    return entries;
  }

  const SweepMap& map_;
  const DrawingOptions& options_;
  double font_;
  double width_;         // of the picture, pixels
  std::size_t columns_;  // panels side by side
  double left_ = 0.0;    // of the first plot, beside the vertical axis
  double plot_width_ = 0.0;
  double plot_height_ = 0.0;
};

}  // namespace

void drawSweepMap(const std::string& path, const SweepMap& map, const std::string& title,
                  const std::string& note, const DrawingOptions& options) {
  AsideFile file(path);
  SweepMapPainter(map, options).paint(file.stream(), title, note);
  file.commit();
}

}  // namespace forge
