#include "collision_forge/study/training/training_draw.h"

#include <algorithm>
#include <cmath>

namespace forge {
namespace {

double gauss(std::mt19937_64& engine) {
  const auto uniform = [&] { return (static_cast<double>(engine() >> 11) + 0.5) * 0x1.0p-53; };
  const double radius = std::sqrt(-2.0 * std::log(uniform()));
  const double angle = 2.0 * M_PI * uniform();
  return radius * std::cos(angle);
}

double uniformOf(std::mt19937_64& engine) {
  return static_cast<double>(engine() >> 11) * 0x1.0p-53;
}

/// Draws the prediction times of a step; the first is the impact if the sample has an attack.
std::vector<const TimedSample*> drawTimes(const TrainingSample& sample, int count,
                                          std::mt19937_64& engine) {
  std::vector<const TimedSample*> times;
  for (int i = 0; i < count; ++i) {
    const bool impact = i == 0 && sample.attack;
    times.push_back(impact ? &sample.times.back() : &sample.times[engine() % sample.times.size()]);
  }
  return times;
}

std::vector<const TimedSample*> evenTimes(const TrainingSample& sample, int count) {
  std::vector<const TimedSample*> times;
  for (int i = 0; i < count; ++i) {
    const std::size_t last = sample.times.size() - 1;
    times.push_back(&sample.times[last - last * static_cast<std::size_t>(i) /
                                             static_cast<std::size_t>(std::max(count - 1, 1))]);
  }
  return times;
}

/// Returns the true ego pose with noise of the size of the network's errors.
Pose2 blurred(const AttackSample& attack, const TrainingOptions& options, std::mt19937_64& engine) {
  const double along =
      options.noise_along * std::pow(attack.tta, options.noise_along_exponent) * gauss(engine);
  const double across = options.noise_across * attack.tta * gauss(engine);
  return compose(attack.ego, {along, across, 0.0});
}

}  // namespace

TrainingDraw randomDraw(const TrainingSample& sample, const TrainingOptions& options,
                        std::mt19937_64& engine) {
  TrainingDraw draw;
  draw.sample = &sample;
  draw.times = drawTimes(sample, options.times, engine);
  draw.hides_history = sample.attack || uniformOf(engine) < options.hidden_history_share;
  const bool turns_left = sample.attack && sample.attack->type == CollisionType::kLtap;
  draw.is_mirrored = uniformOf(engine) < options.mirrored_share && !turns_left;
  if (sample.attack) draw.expected_ego = blurred(*sample.attack, options, engine);
  return draw;
}

TrainingDraw evenDraw(const TrainingSample& sample, const TrainingOptions& options,
                      std::mt19937_64* engine) {
  TrainingDraw draw;
  draw.sample = &sample;
  draw.times = evenTimes(sample, options.times);
  draw.hides_history = sample.attack.has_value();
  if (sample.attack) {
    draw.expected_ego = engine ? blurred(*sample.attack, options, *engine) : sample.attack->ego;
  }
  return draw;
}

}  // namespace forge
