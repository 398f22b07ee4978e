#include "collision_forge/base/scene/moment.h"

#include <algorithm>
#include <cmath>

#include "collision_forge/base/scene/clock.h"
#include "collision_forge/base/scene/formatted.h"

namespace forge {
namespace {

double nearestFrame(const Scene& scene, double time) {
  return *std::min_element(
      scene.frame_times.begin(), scene.frame_times.end(),
      [=](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
}

Status noFrame(double now, double nearest) {
  return {StatusCode::kNoScene,
          formatted("now = %.6f s: the scene has no frame at this time; the nearest is at %.6f s",
                    now, nearest)};
}

}  // namespace

std::shared_ptr<const Snapshot> pastOf(const Scene& scene, double now) {
  return std::make_shared<const Snapshot>(
      snapshotAt(scene, now, static_cast<int>(scene.frame_times.size())));
}

std::variant<Moment, Status> momentAt(const IndexedScene& recording, double now,
                                      int history_frames) {
  const Scene& scene = recording.scene;
  const double frame = nearestFrame(scene, now);
  if (std::abs(frame - now) > kTimeEpsilon) return noFrame(now, frame);
  return Moment{snapshotAt(scene, frame, history_frames), recordedFuture(scene, frame),
                recording.lanes, pastOf(scene, frame)};
}

}  // namespace forge
