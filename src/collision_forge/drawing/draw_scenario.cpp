#include "collision_forge/drawing/draw_scenario.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/drawing/gif_writer.h"
#include "collision_forge/drawing/scenario_painter.h"
#include "collision_forge/files/aside_file.h"

namespace forge {

namespace {

constexpr int kPaletteColors = 255;
constexpr double kTimeTolerance = 1e-6;  // s

/// One picture of the animation.
struct Frame {
  double time = 0.0;  ///< seconds on the scene's clock
  int delay = 0;      ///< hundredths of a second
};

void checkDrawable(const ScenarioView& view, const DrawingOptions& options) {
  if (options.gif_frames_per_second <= 0 || options.ghost_interval <= 0 ||
      options.min_extent <= 0 || options.close_up_extent <= 0) {
    throw std::runtime_error("drawing options: rate, interval and extents must be above zero");
  }
  const std::vector<TrajectoryPoint>& points = view.trajectory.points;
  if (points.empty()) throw std::runtime_error("the attacker's trajectory is empty");
  if (view.future.ego.states.empty()) throw std::runtime_error("the ego's future is empty");
  const double key_time = ScenarioMotion(view).keyTime();
  const bool spanned = key_time >= view.snapshot.now - kTimeTolerance &&
                       key_time <= points.back().time + kTimeTolerance;
  if (!spanned) {
    throw std::runtime_error("the attacker's trajectory does not span now to the contact at " +
                             std::to_string(key_time) + " s");
  }
}

/// The first instant to show: not before the ego's first known state.
double startTime(const ScenarioView& view, const DrawingOptions& options) {
  const double earliest = view.snapshot.now - options.seconds_before_now;
  const std::vector<AgentState>& past = view.snapshot.ego.states;
  return past.empty() ? view.snapshot.now : std::max(earliest, past.front().time);
}

/// Evenly spaced around the contact, which is held.
std::vector<Frame> planFrames(const ScenarioView& view, const DrawingOptions& options) {
  const double rate = options.gif_frames_per_second;
  const double key_time = ScenarioMotion(view).keyTime();
  const auto count = [rate](double seconds) {
    return static_cast<int>(std::floor(seconds * rate + kTimeTolerance));
  };
  const int before = count(key_time - startTime(view, options));
  const int after = count(options.gif_seconds_after_contact);
  std::vector<Frame> frames;
  for (int i = -before; i <= after; ++i) {
    const double seconds = 1.0 / rate + (i == 0 ? options.gif_contact_hold : 0.0);
    frames.push_back({key_time + i / rate, static_cast<int>(std::lround(100.0 * seconds))});
  }
  return frames;
}

void writePng(std::ostream& file, const ScenarioView& view, const DrawingOptions& options) {
  checkDrawable(view, options);
  const ScenarioPainter painter(view, options, pngSize(options));
  painter.paint(ScenarioMotion(view).keyTime(), view.snapshot.now).writePng(file);
}

/// Paints every frame twice, for the shared palette and for the file: that is quicker than it is
/// big to keep them.
void writeGif(std::ostream& file, const ScenarioView& view, const DrawingOptions& options) {
  checkDrawable(view, options);
  const ScenarioPainter painter(view, options, gifSize(options), PictureKind::kAnimation);
  const std::vector<Frame> frames = planFrames(view, options);
  ColorHistogram histogram;
  for (const Frame& frame : frames) histogram.add(painter.paint(frame.time, frame.time));
  const ColorPalette palette(histogram, kPaletteColors);
  GifWriter writer(file, options.gif_width, options.gif_height, palette);
  for (const Frame& frame : frames) {
    writer.addFrame(painter.paint(frame.time, frame.time), frame.delay);
  }
  writer.close();
}

void writeSheet(std::ostream& file, const std::vector<ScenarioView>& views, int columns,
                const DrawingOptions& options) {
  const FigureSize size = gifSize(options);
  const int rows = (static_cast<int>(views.size()) + columns - 1) / columns;
  Image sheet(columns * size.width, rows * size.height, options.background_color);
  Canvas canvas(sheet);
  for (std::size_t i = 0; i < views.size(); ++i) {
    checkDrawable(views[i], options);
    const ScenarioPainter painter(views[i], options, size);
    const int place = static_cast<int>(i);
    canvas.image({static_cast<double>(place % columns * size.width),
                  static_cast<double>(place / columns * size.height)},
                 painter.paint(ScenarioMotion(views[i]).keyTime(), views[i].snapshot.now));
  }
  sheet.writePng(file);
}

/// Writes aside; errors name the file.
template <typename Write>
void writeAside(const std::string& path, const Write& write) {
  AsideFile file(path);
  std::ostream& stream = file.stream();
  try {
    write(stream);
  } catch (const std::exception& error) {
    throw std::runtime_error("cannot draw " + path + ": " + error.what());
  }
  file.commit();
}

}  // namespace

void drawScenarioPng(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options) {
  writeAside(path, [&](std::ostream& file) { writePng(file, view, options); });
}

void drawScenarioSheet(const std::string& path, const std::vector<ScenarioView>& views, int columns,
                       const DrawingOptions& options) {
  if (views.empty() || columns < 1) {
    throw std::invalid_argument("a sheet of " + std::to_string(views.size()) + " pictures in " +
                                std::to_string(columns) + " columns");
  }
  writeAside(path, [&](std::ostream& file) { writeSheet(file, views, columns, options); });
}

void drawScenarioGif(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options) {
  writeAside(path, [&](std::ostream& file) { writeGif(file, view, options); });
}

}  // namespace forge
