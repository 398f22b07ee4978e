#pragma once

#include <random>

#include "attack/search/test_scenes.h"
#include "collision_forge/attack/network/pattern_network.h"

namespace forge {

/// Small options with every field of config/training.yaml set.
inline PatternFeatureOptions smallFeatures() {
  PatternFeatureOptions options;
  options.history_frames = 8;
  options.agent_frames = 8;
  options.max_agents = 4;
  options.encoding = {60.0, 6, 5, 6.0};
  options.max_ways = 4;
  options.way_anchors = 9;
  options.spacing_floor = 0.05;
  options.spacing_rate = 0.5;
  options.spacing_exponent = 1.5;
  options.target_lanes = 5;
  options.target_points = 6;
  options.target_spacing = 4.0;
  return options;
}

inline PatternNetworkOptions smallLayers() {
  PatternNetworkOptions options;
  options.hidden = 8;
  options.scene = 12;
  options.anchor = 6;
  return options;
}

/// Random, untrained weights.
inline PatternWeights randomWeights(std::uint64_t seed = 0) {
  std::mt19937_64 engine(seed);
  PatternWeights weights;
  weights.features = smallFeatures();
  weights.network = smallLayers();
  for (const auto& [name, shape] : layerShapes(weights.network)) {
    LinearWeights& layer = weights.layers[name];
    const auto draw = [&] {
      return static_cast<float>(static_cast<double>(engine() >> 11) * 0x1.0p-53 - 0.5);
    };
    layer.matrix = RowMatrix::NullaryExpr(shape.outputs, shape.inputs, draw);
    layer.bias = Eigen::VectorXf::NullaryExpr(shape.outputs, draw);
  }
  return weights;
}

/// The ego eastbound at 8 m/s before a junction; one vehicle ahead, one oncoming, one from the
/// right.
inline Snapshot junctionSnapshot() {
  auto map = fourWayJunction();
  return snapshotOf(pastTrack(kEgoId, kEgoSize, {-30.0, -1.75, 0.0}, 8.0),
                    {pastTrack("ahead", kCarSize, {-5.0, -1.75, 0.0}, 6.0),
                     pastTrack("oncoming", kCarSize, {40.0, 1.75, M_PI}, 9.0),
                     pastTrack("crossing", kCarSize, {1.75, -35.0, M_PI_2}, 7.0)},
                    map);
}

inline LaneIndex lanesOf(const Snapshot& snapshot) { return LaneIndex(snapshot.map); }

}  // namespace forge
