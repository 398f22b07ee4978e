#pragma once

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "collision_forge/attack/network/options.h"
#include "collision_forge/attack/network/row_matrix.h"

namespace forge {

// Output scales, equal in training and inference.
inline constexpr double kMaxLogSpread = 3.0;  ///< bound of |log(spread / anchor scale)|
inline constexpr double kOffsetScale = 4.0;   ///< m, unit of the attacker's predicted offset

/// y = matrix * x + bias.
struct LinearWeights {
  RowMatrix matrix;      ///< [outputs, inputs]
  Eigen::VectorXf bias;  ///< [outputs]
};

/// A trained pattern network: options and layers.
struct PatternWeights {
  PatternFeatureOptions features;
  PatternNetworkOptions network;
  std::vector<std::string> left_out_scenes;     ///< not in its training set
  std::map<std::string, LinearWeights> layers;  ///< by name, as layerShapes()
};

/// Size of a linear layer.
struct LayerShape {
  int inputs = 0;
  int outputs = 0;
};
/// Returns the layers of a network with these widths by name.
std::map<std::string, LayerShape> layerShapes(const PatternNetworkOptions& options);

/// Throws std::invalid_argument, naming the layer, if a layer is missing, unknown, of the wrong
/// shape or has numbers that are not finite or too large, or if a width is not positive.
void checkWeights(const PatternWeights& weights);

}  // namespace forge
