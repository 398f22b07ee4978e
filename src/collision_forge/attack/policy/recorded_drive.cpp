#include "collision_forge/attack/policy/recorded_drive.h"

#include <chrono>
#include <limits>

#include "collision_forge/base/scene/clock.h"

namespace forge {
namespace {

constexpr double kNotObserved = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Frame frameAt(const Scene& scene, double time) {
  const auto ego = stateAt(scene.ego, time);
  return {time, ego ? ego->pose : Pose2{kNotObserved, kNotObserved, kNotObserved},
          agentsAt(scene.agents, time)};
}

std::vector<double> driveOverRecording(AttackerPolicy& policy, const Scene& scene, double now) {
  std::vector<double> milliseconds;
  const double end = policy.trajectory().points.back().time;
  for (const double time : scene.frame_times) {
    if (time <= now + kTimeEpsilon || time >= end) continue;
    const Frame frame = frameAt(scene, time);
    const auto begin = std::chrono::steady_clock::now();
    policy.observe(frame);
    const std::chrono::duration<double, std::milli> taken =
        std::chrono::steady_clock::now() - begin;
    milliseconds.push_back(taken.count());
  }
  return milliseconds;
}

}  // namespace forge
