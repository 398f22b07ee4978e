#pragma once

#include <random>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_sample.h"

namespace forge {

/// What one step looks at of a sample, which must outlive it.
struct TrainingDraw {
  const TrainingSample* sample = nullptr;
  std::vector<const TimedSample*>
      times;                   ///< TrainingOptions::times of them; of an attack's the impact
  bool hides_history = false;  ///< of all others
  bool is_mirrored = false;    ///< left and right are exchanged
  Pose2 expected_ego;          ///< of an attack, as uncertain as the network will be; not mirrored
};

/// At random; left turns are never mirrored.
TrainingDraw randomDraw(const TrainingSample& sample, const TrainingOptions& options,
                        std::mt19937_64& engine);

/// Times from the last one on evenly, nothing mirrored, and no history but that of clips hidden.
/// What is expected of the ego is where it went; with `engine` as uncertain as above.
TrainingDraw evenDraw(const TrainingSample& sample, const TrainingOptions& options,
                      std::mt19937_64* engine = nullptr);

}  // namespace forge
