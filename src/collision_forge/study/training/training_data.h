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
  LogSource logs;       ///< recorded scenes; with clips also the nuScenes root with their maps
  std::string collide;  ///< folder of COLLIDE clips; empty: none
  std::vector<std::string> splits;  ///< splits of the clips to use: train, val, test
  int jobs = 1;                     ///< number of threads that read

  /// Returns true if the training uses logs. False for clips with a nuScenes root without a table
  /// version, which then only provides maps.
  bool hasLogs() const;
};

/// Returns the sorted names, each once, of all scenes of the logs and clips.
std::vector<std::string> sceneNames(const TrainingSources& sources);

/// Returns the scenes of `names` in fold `fold` (1 to `folds`). The folds partition the scenes
/// evenly; `seed` determines the assignment. Empty if there are fewer than `fold` scenes. `names`
/// may be in any order, without repetitions.
std::set<std::string> scenesOfFold(std::vector<std::string> names, int fold, int folds,
                                   std::uint64_t seed);

/// Returns the training samples of all scenes except `left_out`: one per frame for the egos of
/// logs, one every `vehicle_stride` s for moving car-like vehicles (isCarLike()) of logs in the
/// role of the ego, each if it has two frames of history and a later state, and one per clip.
/// Ordered by scenes of the logs, then clips; the order does not depend on sources.jobs. Calls
/// `on_item` (under a lock, from worker threads) with the number of scenes and clips done and their
/// number in total; it must not throw. Rethrows the first exception of a worker.
std::vector<TrainingSample> collectTrainingSamples(
    const TrainingSources& sources, const LearningOptions& options,
    const std::set<std::string>& left_out, std::uint64_t seed,
    const std::function<void(std::size_t, std::size_t)>& on_item);

/// Returns the sample of the clip in the file `path` at its t0. Its times are `others` random
/// frames after t0 (which may be the impact) and the impact as last one. `lanes`: map of the clip's
/// city. `features`: the feature options of the network. TrainingSample::attack is empty if the
/// clip's attacker is no candidate (isCandidate()). At present never returns nullopt. Throws as
/// readCollideClip().
std::optional<TrainingSample> clipSample(const std::string& path, const LaneIndex& lanes,
                                         const LearningOptions& options,
                                         const PatternFeatureOptions& features, int others,
                                         std::uint64_t seed);

}  // namespace forge
