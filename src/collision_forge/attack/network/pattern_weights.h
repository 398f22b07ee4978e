#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"

namespace forge {

// What outputs are in, in training and in use alike.
inline constexpr double kMaxLogSpread = 3.0;  ///< of spreads over the anchors' scales
inline constexpr double kOffsetScale = 4.0;   ///< m

/// y = matrix * x + bias.
struct LinearWeights {
  RowMatrix matrix;      ///< [outputs, inputs]
  Eigen::VectorXf bias;  ///< [outputs]
};

/// Everything that a pattern network is.
struct PatternWeights {
  PatternFeatureOptions features;
  PatternNetworkOptions network;
  std::vector<std::string> left_out_scenes;  ///< that it was not trained on
  std::map<std::string, LinearWeights> layers;
};

/// Inputs and outputs of a layer.
struct LayerShape {
  int inputs = 0;
  int outputs = 0;
};
/// The layers of the architecture by their names.
std::map<std::string, LayerShape> layerShapes(const PatternNetworkOptions& options);

/// Throws std::invalid_argument, naming the layer, when a layer is missing, unknown, of another
/// shape or not finite, and for options that are not positive.
void checkWeights(const PatternWeights& weights);

}  // namespace forge
