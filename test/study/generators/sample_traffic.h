#pragma once

#include "collision_forge/study/generators/traffic_generator.h"
#include "collision_forge/study/settings/study_config.h"
#include "io/collide/collide_fixture.h"

namespace forge {

inline StudyConfig shippedConfig() { return loadStudyConfig(COLLISION_FORGE_SOURCE_DIR "/config"); }

/// Options of a model that ignores lanes.
inline TrafficOptions withoutLanes(TrafficOptions options) {
  options.lanes = {};
  return options;
}

/// Options of generators that ignore lanes.
inline GeneratorOptions blindOptions() {
  GeneratorOptions options = shippedConfig().generators;
  options.traffic = withoutLanes(options.traffic);
  return options;
}

/// Rear-end clips: the ego at 5 m/s and more, the attacker behind it with a different speed in
/// each.
inline std::vector<TrafficClip> sampleClips(const TrafficOptions& options, int count) {
  std::vector<TrafficClip> clips;
  for (int i = 0; i < count; ++i) {
    const CollideClip clip = straightClip(CollisionType::kRearEnd, 0.0, 12, 5.0 + i,
                                          {-20.0, 1.0 * i, 0.0}, 9.0 + 0.5 * i);
    clips.push_back(trafficOf(clip, {{4.7, 2.0}, 2.0, 0.1}, options, nullptr));
  }
  return clips;
}

/// Returns all windows of the clips as one batch, with their future.
inline TrafficBatch sampleBatch(const std::vector<TrafficClip>& clips,
                                const TrafficOptions& options) {
  std::vector<TrafficWindow> windows;
  for (const TrafficClip& clip : clips) {
    for (const TrafficWindow& window : windowsOf(clip, options)) windows.push_back(window);
  }
  return batchOf(windows, options, options.future_frames);
}

/// Returns the mean displacement error (m) of the generator over all agents and frames.
inline double driveError(const TrafficGenerator& generator, const TrafficBatch& batch,
                         const TrafficOptions& options) {
  const torch::NoGradGuard no_gradients;
  generator.network()->eval();
  const torch::Tensor driven =
      generator.predict(historyOf(batch, options.history_frames), noiseOf(1));
  const torch::Tensor came = batch.poses.slice(2, options.history_frames);
  return (driven - came).slice(3, 0, 2).norm(2, 3).mean().item<double>();
}

}  // namespace forge
