#pragma once

#include <random>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/study/training/options.h"
#include "collision_forge/study/training/training_sample.h"

namespace forge {

/// The (random) choices for one use of a sample in a training step or a computation of losses.
/// Refers to the sample, which must outlive it.
struct TrainingDraw {
  const TrainingSample* sample = nullptr;  ///< the sample, not null in a draw
  /// TrainingOptions::times elements of sample->times; includes the impact if the sample has an
  /// attack.
  std::vector<const TimedSample*> times;
  bool hides_history = false;  ///< removes the history of other agents
  bool is_mirrored = false;    ///< exchanges left and right
  Pose2 expected_ego;  ///< ego pose at the impact with noise, in the frame of the ego at t0, not
                       ///< mirrored; candidates are scored with it. Unused without an attack
};

/// Draws times (with replacement; the first is the impact if there is an attack), mirroring, hidden
/// history and noise at random, from `engine`. Always hides the history of samples with an attack,
/// never mirrors left turns (ltap).
TrainingDraw randomDraw(const TrainingSample& sample, const TrainingOptions& options,
                        std::mt19937_64& engine);

/// Draws without augmentation: TrainingOptions::times times, evenly spaced by index from the last
/// back to the first (repeated if there are fewer), no mirroring; hides the history only for
/// samples with an attack. `expected_ego` is the true pose; with `engine`, noise of the same size
/// as in randomDraw() is added.
TrainingDraw evenDraw(const TrainingSample& sample, const TrainingOptions& options,
                      std::mt19937_64* engine = nullptr);

}  // namespace forge
