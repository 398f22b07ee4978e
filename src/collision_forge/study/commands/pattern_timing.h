#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

#include "collision_forge/attack/network/predicted_scene.h"
#include "collision_forge/attack/search/options.h"

namespace forge {

/// Measures the CPU time (of the calling thread) that the collision-pattern network takes per
/// scene.
class PatternTiming {
 public:
  static constexpr std::size_t kBatch = 32;  ///< scenes

  /// Times each stage of the network on one scene; after every kBatch scenes also times encoder and
  /// heads over the whole batch. `tta` in s.
  void add(const PredictedScene& scene, const PatternNetwork& network, const LaneIndex& lanes,
           double tta, CollisionType type, int candidates, const EgoFutureOptions& options) {
    Input input;
    const PatternFeatureOptions& sizes = network.weights().features;
    features_.push_back(timed([&] {
      const EgoWays ways = egoWays(scene.observed(), lanes, tta, options, sizes.max_ways);
      input.scene = sceneFeatures(scene.observed(), lanes, sizes);
      input.anchors = anchorFeatures(ways, lanes, tta, options, sizes);
      input.request = requestFeatures(type, tta);
    }));
    input.candidates = RowMatrix::Zero(std::max(candidates, 1), kCandidateFeatures);
    Eigen::VectorXf encoded;
    encoder_.push_back(timed([&] { encoded = network.encode(input.scene); }));
    heads_.push_back(timed([&] { runHeads(network, encoded, input); }));
    whole_.push_back(timed([&] { runHeads(network, network.encode(input.scene), input); }));
    waiting_.push_back(std::move(input));
    if (waiting_.size() == kBatch) finishBatch(network);
  }

  /// Prints the medians on stdout, in ms.
  void print() const {
    std::printf("features %.3f ms, encoder %.3f ms, heads %.3f ms, features to pattern %.3f ms",
                median(features_), median(encoder_), median(heads_), median(whole_));
    std::printf("; in a batch of %zu, features to pattern: mean of a scene %.3f ms (medians)\n",
                kBatch, median(batches_));
  }

 private:
  struct Input {
    SceneFeatures scene;
    AnchorFeatures anchors;
    Eigen::VectorXf request;
    RowMatrix candidates;
  };
  static constexpr int kCalls = 20;

  static void runHeads(const PatternNetwork& network, const Eigen::VectorXf& encoded,
                       const Input& input) {
    const Eigen::VectorXf with_request = network.withRequest(encoded, input.request);
    medianPose(network.ego(with_request, input.anchors));
    network.candidates(with_request, input.candidates);
  }

  /// Returns the CPU time of this thread, ms.
  static double processorTime() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  /// Returns the mean time of one call of `work`, ms.
  template <typename Work>
  static double timed(Work work) {
    const double begin = processorTime();
    for (int i = 0; i < kCalls; ++i) work();
    return (processorTime() - begin) / kCalls;
  }

  /// Times the scenes of the batch one after the other, so that caches are not warm as in add().
  void finishBatch(const PatternNetwork& network) {
    const double all = timed([&] {
      for (const Input& input : waiting_) runHeads(network, network.encode(input.scene), input);
    });
    batches_.push_back(all / static_cast<double>(kBatch));
    waiting_.clear();
  }

  static double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return values.empty() ? 0.0 : values[values.size() / 2];
  }

  std::vector<Input> waiting_;
  std::vector<double> features_;
  std::vector<double> encoder_;
  std::vector<double> heads_;
  std::vector<double> whole_;
  std::vector<double> batches_;
};

}  // namespace forge
