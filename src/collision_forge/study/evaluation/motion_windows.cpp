#include "collision_forge/study/evaluation/motion_windows.h"

#include <cmath>
#include <utility>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr double kShortestStep = 0.25;  // s between successive samples of a recorded window
constexpr double kLongestStep = 0.75;   // s
constexpr double kLeastWay = 1.0;       // m between the first and the last sample

bool evenlySampled(const std::vector<AgentState>& states, std::size_t first) {
  for (std::size_t i = first + 1; i < first + kWindowSamples; ++i) {
    const double step = states[i].time - states[i - 1].time;
    if (step < kShortestStep || step > kLongestStep) return false;
  }
  return true;
}

bool moves(const MotionWindow& window) {
  const Vector2 way =
      window.samples.back().pose.position() - window.samples.front().pose.position();
  return way.norm() >= kLeastWay;
}

}  // namespace

std::vector<MotionWindow> recordedWindows(const std::string& scene, const Track& track) {
  std::vector<MotionWindow> windows;
  if (!canAttack(track.agent_class)) return windows;
  for (std::size_t first = 0; first + kWindowSamples <= track.states.size(); ++first) {
    if (!evenlySampled(track.states, first)) continue;
    MotionWindow window{scene, track.id, track.agent_class, track.size, {}, 0};
    for (std::size_t i = 0; i < kWindowSamples; ++i) {
      const AgentState& state = track.states[first + i];
      window.samples[i] = {state.time, state.pose};
    }
    if (moves(window)) windows.push_back(std::move(window));
  }
  return windows;
}

std::optional<MotionWindow> attackWindow(const std::string& scene, const Track& recorded,
                                         const AttackerTrajectory& trajectory, double contact_time,
                                         double before_contact) {
  if (trajectory.points.empty()) return std::nullopt;
  const double now = trajectory.points.front().time;
  const double left = contact_time - before_contact - now;
  const int newest = static_cast<int>(std::floor((left + kTimeEpsilon) / kWindowStep));
  if (newest < 1) return std::nullopt;
  MotionWindow window{scene, trajectory.attacker_id, trajectory.agent_class, trajectory.size, {},
                      0};
  window.generated = std::min<std::size_t>(static_cast<std::size_t>(newest), kWindowSamples);
  for (std::size_t i = 0; i < kWindowSamples; ++i) {
    const int step = newest + 1 + static_cast<int>(i) - static_cast<int>(kWindowSamples);
    const double time = now + step * kWindowStep;
    if (step > 0) {
      window.samples[i] = {time, poseAt(trajectory, time)};
      continue;
    }
    const std::optional<AgentState> past = stateAt(recorded, time);
    if (!past) return std::nullopt;
    window.samples[i] = {time, past->pose};
  }
  return window;
}

}  // namespace forge
