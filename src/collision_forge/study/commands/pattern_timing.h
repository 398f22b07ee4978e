#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <vector>

#include "collision_forge/attack/network/predicted_scene.h"
#include "collision_forge/attack/search/options.h"

namespace forge {

/// How long a network takes for scene after scene, in processor time of the calling thread.
class PatternTiming {
 public:
  static constexpr std::size_t kBatch = 32;  ///< scenes

  /// Times the stages of one scene, and of all of the last kBatch when there are as many.
  void add(const PredictedScene& scene, const PatternNetwork& network, const LaneIndex& lanes,
           double tta, CollisionType type, int candidates) {
    Input input;
    const PatternFeatureOptions& sizes = network.weights().features;
    features_.push_back(timed([&] {
      const EgoWays ways = egoWays(scene.observed(), lanes, tta, sizes.max_ways);
      input.scene = sceneFeatures(scene.observed(), lanes, sizes);
      input.anchors = anchorFeatures(ways, lanes, tta, sizes);
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

  /// Milliseconds that this thread has had a core.
  static double processorTime() {
    timespec now = {};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
  }

  /// Milliseconds of one of several calls.
  template <typename Work>
  static double timed(Work work) {
    const double begin = processorTime();
    for (int i = 0; i < kCalls; ++i) work();
    return (processorTime() - begin) / kCalls;
  }

  /// Scenes one after the other, as one caller has them: nothing is kept warm for the next call.
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
