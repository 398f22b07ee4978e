#include "collision_forge/io/drawing/draw_scenario.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "collision_forge/base/files/aside_file.h"
#include "collision_forge/io/drawing/animation.h"
#include "collision_forge/io/drawing/caption_painter.h"
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
  checkDrawable(view, options);
  const ScenarioPainter painter(view, options, pngSize(options));
  painter.paint(ScenarioMotion(view).keyTime(), view.snapshot.now).writePng(file);
}

void writeGif(std::ostream& file, const ScenarioView& view, const DrawingOptions& options) {
  checkDrawable(view, options);
  const ScenarioPainter painter(view, options, gifSize(options), PictureKind::kAnimation);
  writeAnimation(file, planFrames(view, options),
                 [&](double time) { return painter.paint(time, time); });
}

/// Calls `write` with a stream to an AsideFile for `path`. Throws std::runtime_error naming the
/// file if anything fails.
template <typename Write>
void drawAside(const std::string& path, const Write& write) {
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
  drawAside(path, [&](std::ostream& file) { writePng(file, view, options); });
}

void drawScenarioGif(const std::string& path, const ScenarioView& view,
                     const DrawingOptions& options) {
  drawAside(path, [&](std::ostream& file) { writeGif(file, view, options); });
}

}  // namespace forge
