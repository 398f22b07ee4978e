#pragma once

#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "collision_forge/io/logs/log_source.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_sample.h"

namespace forge {

/// What a network is trained on.
struct TrainingSources {
  LogSource logs;                   ///< for clips a nuScenes root, with their maps
  std::string collide;              ///< folder of clips; empty: none
  std::vector<std::string> splits;  ///< of the clips
  int jobs = 1;                     ///< threads

  /// False where the logs are there for the maps of clips alone: no version of their tables is
  /// named.
  bool hasLogs() const;
};

/// Names of all scenes of the logs and clips, sorted.
std::vector<std::string> sceneNames(const TrainingSources& sources);

/// The scenes of fold `fold` (1 to `folds`): every scene is in one, dealt by the seed.
std::set<std::string> scenesOfFold(std::vector<std::string> names, int fold, int folds,
                                   std::uint64_t seed);

/// A moment of each frame of the logs' egos, of the logs' moving vehicles in the ego's place, and
/// of each clip, in the order of the scenes whatever the number of jobs. Nothing of the scenes in
/// `left_out` is read. `on_item` is told logs and clips done, of how many.
std::vector<TrainingSample> collectTrainingSamples(
    const TrainingSources& sources, const LearningOptions& options,
    const std::set<std::string>& left_out, std::uint64_t seed,
    const std::function<void(std::size_t, std::size_t)>& on_item);

/// The sample of a clip at its now: the impact, and `others` earlier instants after now. `lanes` of
/// the clip's city.
std::optional<TrainingSample> clipSample(const std::string& path, const LaneIndex& lanes,
                                         const LearningOptions& options,
                                         const PatternFeatureOptions& features, int others,
                                         std::uint64_t seed);

}  // namespace forge
