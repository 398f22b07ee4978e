#include "batch/request_answerer.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "attack/generator.h"

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

RequestAnswerer::RequestAnswerer(SceneSource& scenes, const Config& config)
    : scenes_(scenes), config_(config), speeds_(loadSpeedForecaster(config)) {}

Scenario RequestAnswerer::answer(const SceneRequest& asked) const {
  Scenario scenario{asked, config_.ego_vehicle, {}};
  const auto indexed = scenes_.at(asked.scene);
  const double now = nearestFrame(indexed->scene, asked.now);
  if (std::abs(now - asked.now) > kTimeEpsilon) {
    scenario.answer.status = noFrame(asked.now, now);
    return scenario;
  }
  const Snapshot snapshot =
      snapshotAt(indexed->scene, now, config_.attack.prediction.history_frames);
  const Future recorded = recordedFuture(indexed->scene, now);
  const KinematicPatternPredictor predictor(
      config_.attack,
      std::make_shared<KinematicEgoFutures>(config_.attack.ego_futures, speeds_, asked.scene));
  scenario.answer = generateCollision(asked.request, snapshot, *indexed->lanes, &recorded,
                                      predictor, config_.attack);
  return scenario;
}

}  // namespace forge
