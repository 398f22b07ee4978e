#include "collision_forge/study/request_answerer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "collision_forge/attack/generator.h"

namespace forge {
namespace {

constexpr double kTimeEpsilon = 1e-6;  // s, the resolution of the clock

double nearestFrame(const Scene& scene, double time) {
  return *std::min_element(
      scene.frame_times.begin(), scene.frame_times.end(),
      [=](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
}

Status noFrame(double now, double nearest) {
  char message[160];
  std::snprintf(message, sizeof(message),
                "now = %.6f s is the time of no frame of the scene; the nearest is at %.6f s", now,
                nearest);
  return {StatusCode::kNoScene, message};
}

}  // namespace

RecordedMoment momentAt(const Scene& scene, double now, int history_frames) {
  const double frame = nearestFrame(scene, now);
  if (std::abs(frame - now) > kTimeEpsilon) return {noFrame(now, frame), {}, {}};
  return {{}, snapshotAt(scene, frame, history_frames), recordedFuture(scene, frame)};
}

RequestAnswerer::RequestAnswerer(SceneSource& scenes, const Config& config, Foresight foresight)
    : scenes_(scenes), config_(config), foresight_(std::move(foresight)) {}

Scenario RequestAnswerer::answer(const SceneRequest& asked) const {
  return answer(asked, *scenes_.at(asked.scene));
}

Scenario RequestAnswerer::answer(const SceneRequest& asked, const IndexedScene& indexed) const {
  Scenario scenario{asked, config_.ego_vehicle, {}};
  const RecordedMoment moment =
      momentAt(indexed.scene, asked.now, config_.attack.prediction.history_frames);
  scenario.answer.status = moment.status;
  if (moment.status.code != StatusCode::kOk) return scenario;
  const auto predictor = foresight_.withoutScene(asked.scene).patterns(config_.attack);
  scenario.answer = generateCollision(asked.request, moment.snapshot, *indexed.lanes,
                                      &moment.recorded, *predictor, config_.attack);
  return scenario;
}

}  // namespace forge
