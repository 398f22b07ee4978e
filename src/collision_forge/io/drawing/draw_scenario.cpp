#include "collision_forge/io/drawing/draw_scenario.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/io/drawing/animation.h"
#include "collision_forge/io/drawing/caption_painter.h"
#include "collision_forge/io/drawing/draw_aside.h"
#include "collision_forge/io/drawing/scenario_painter.h"

namespace forge {

namespace {

constexpr double kTimeTolerance = 1e-6;  // s

/// Returns the first time to show: not before the ego's first known state.
double startTime(const ScenarioView& view, const DrawingOptions& options) {
  const double earliest = view.snapshot.now - options.seconds_before_now;
  const std::vector<AgentState>& past = view.snapshot.ego.states;
  return past.empty() ? view.snapshot.now : std::max(earliest, past.front().time);
}

/// Returns evenly spaced frames around the contact; the frame at contact is held.
std::vector<AnimationFrame> planFrames(const ScenarioView& view, const DrawingOptions& options) {
  const double rate = options.gif_frames_per_second;
  const ScenarioMotion motion(view);
  const double key_time = motion.keyTime();
  const auto count = [rate](double seconds) {
    return static_cast<int>(std::floor(seconds * rate + kTimeTolerance));
  };
  const int before = count(key_time - startTime(view, options));
  const int after = count(motion.endTime() - key_time);
  std::vector<AnimationFrame> frames;
  for (int i = -before; i <= after; ++i) {
    const double seconds = 1.0 / rate + (i == 0 ? options.gif_contact_hold : 0.0);
    frames.push_back({key_time + i / rate, static_cast<int>(std::lround(100.0 * seconds))});
  }
  return frames;
}

void writePng(std::ostream& file, const ScenarioView& view, const DrawingOptions& options) {
  checkDrawable(view, options, true);
  const ScenarioPainter painter(view, options, pngSize(options));
  painter.paint(ScenarioMotion(view).keyTime(), view.snapshot.now).writePng(file);
}

void writeGif(std::ostream& file, const ScenarioView& view, const DrawingOptions& options) {
  checkDrawable(view, options, true);
  const ScenarioPainter painter(view, options, gifSize(options), PictureKind::kAnimation);
  writeAnimation(file, planFrames(view, options),
                 [&](double time) { return painter.paint(time, time); });
}

void writeSheet(std::ostream& file, const std::vector<ScenarioView>& views, int columns,
                const DrawingOptions& options) {
  std::vector<Image> pictures;
  for (const ScenarioView& view : views) {
    checkDrawable(view, options, true);
    const ScenarioPainter painter(view, options, gifSize(options));
    pictures.push_back(painter.paint(ScenarioMotion(view).keyTime(), view.snapshot.now));
  }
  int height = 0;
  for (const Image& picture : pictures) height = std::max(height, picture.height());
  const int width = pictures.front().width();
  const int rows = (static_cast<int>(views.size()) + columns - 1) / columns;
  Image sheet(columns * width, rows * height, options.background_color);
  Canvas canvas(sheet);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    const int place = static_cast<int>(i);
    canvas.image({static_cast<double>(place % columns * width),
                  static_cast<double>(place / columns * height)},
                 pictures[i]);
  }
  sheet.writePng(file);
}

}  // namespace

void drawScenarioPng(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options) {
  drawAside(path, [&](std::ostream& file) { writePng(file, view, options); });
}

void drawScenarioSheet(const std::string& path, const std::vector<ScenarioView>& views, int columns,
                       const DrawingOptions& options) {
  if (views.empty() || columns < 1) {
    throw std::invalid_argument("sheet of " + std::to_string(views.size()) + " pictures in " +
                                std::to_string(columns) + " columns needs at least one of each");
  }
  drawAside(path, [&](std::ostream& file) { writeSheet(file, views, columns, options); });
}

void drawScenarioGif(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options) {
  drawAside(path, [&](std::ostream& file) { writeGif(file, view, options); });
}

}  // namespace forge
