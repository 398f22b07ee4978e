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

/// The data of a training.
struct TrainingSources {
  LogSource logs;                   ///< recorded scenes; with clips a nuScenes root with their maps
  std::string collide;              ///< folder of COLLIDE clips; empty: none
  std::vector<std::string> splits;  ///< splits of the clips: train, val, test
  int jobs = 1;                     ///< threads

  /// Returns true if the training uses logs. False for clips with a nuScenes root without a table
  /// version, which then only provides maps.
  bool hasLogs() const;
};

/// Returns the sorted names of all scenes of the logs and clips.
std::vector<std::string> sceneNames(const TrainingSources& sources);

/// Returns the scenes of fold `fold` (1 to `folds`). The folds partition the scenes; `seed`
/// determines the assignment.
std::set<std::string> scenesOfFold(std::vector<std::string> names, int fold, int folds,
                                   std::uint64_t seed);

/// Returns the training samples of all scenes except `left_out`: one per frame for the egos of
/// logs, one every `vehicle_stride` s for moving vehicles of logs in the role of the ego, and one
/// per clip. The order does not depend on sources.jobs. Calls `on_item` (under a lock, from worker
/// threads) with the numbers of scenes and clips done and in total. Rethrows the first exception of
/// a worker.
std::vector<TrainingSample> collectTrainingSamples(
    const TrainingSources& sources, const LearningOptions& options,
    const std::set<std::string>& left_out, std::uint64_t seed,
    const std::function<void(std::size_t, std::size_t)>& on_item);

/// Returns the sample of a clip at its t0, with `others` random earlier times and the impact as
/// last time. `lanes`: map of the clip's city. The attack is empty if the clip's attacker is no
/// candidate.
std::optional<TrainingSample> clipSample(const std::string& path, const LaneIndex& lanes,
                                         const LearningOptions& options,
                                         const PatternFeatureOptions& features, int others,
                                         std::uint64_t seed);

}  // namespace forge
