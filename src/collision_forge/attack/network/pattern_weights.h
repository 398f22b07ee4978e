#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"

namespace forge {

// Output scales, equal in training and inference.
/// bound of |log(spread / scale)|; scale: AnchorFeatures
inline constexpr double kMaxLogSpread = 3.0;
inline constexpr double kOffsetScale = 4.0;  ///< m, unit of the attacker's predicted offset

/// y = matrix * x + bias.
struct LinearWeights {
  RowMatrix matrix;      ///< [outputs, inputs]
  Eigen::VectorXf bias;  ///< [outputs]
};

/// A trained pattern network: options and layers.
struct PatternWeights {
  PatternFeatureOptions features;               ///< how its input is encoded
  PatternNetworkOptions network;                ///< widths of its layers
  std::vector<std::string> left_out_scenes;     ///< names of scenes not in its training set
  std::map<std::string, LinearWeights> layers;  ///< by name, as layerShapes()
};

/// Size of a linear layer.
struct LayerShape {
  int inputs = 0;
  int outputs = 0;
};
/// Returns the shapes of all 16 layers of a network with these widths, by the layer's name:
/// "agent_first", "agent_second", "lane_first", "lane_second", "query", "key", "value", "scene",
/// "request", "group", "anchor_first", "anchor_second", "anchor_last", "candidate_first",
/// "candidate_second" and "candidate_last".
std::map<std::string, LayerShape> layerShapes(const PatternNetworkOptions& options);

/// Throws std::invalid_argument, naming the layer, if a layer is missing, unknown, of the wrong
/// shape or has numbers that are not finite or beyond 1e6, or if a width is not positive.
void checkWeights(const PatternWeights& weights);

}  // namespace forge
