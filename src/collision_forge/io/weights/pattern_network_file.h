#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/network/pattern_network.h"
#include "collision_forge/attack/network/prediction_models.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Thrown for a file without pattern networks, or with damaged ones. Names file, network and field.
struct PatternNetworkFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Reads the networks of a file; the one trained on all scenes is first, then its folds, in the
/// file's order. Each network is a line of JSON (`format`; `left_out_scenes`; `features` and
/// `network` with the fields of PatternFeatureOptions and PatternNetworkOptions; `layers` with
/// name, outputs and inputs of every layer), followed for each layer by its matrix row by row and
/// its bias, as little-endian 32-bit floats. Throws PatternNetworkFileError for a file that is
/// missing, empty, truncated, or of another architecture.
std::vector<PatternWeights> readPatternWeights(const std::string& path);

/// Writes a file that readPatternWeights() reads. Throws as AsideFile. The first network must be
/// the one trained on all scenes.
void writePatternWeights(const std::vector<PatternWeights>& networks, const std::string& path);

/// Loads the network of a file with its folds (networks trained without some scenes); null if
/// `path` is "". Throws as readPatternWeights().
std::shared_ptr<const PatternNetwork> loadPatternNetwork(const std::string& path);

/// Loads the speed forecaster and the pattern network whose paths are in `options`; a model without
/// a path is null. Throws as loadSpeedForecaster() and loadPatternNetwork().
PredictionModels loadPredictionModels(const ModelOptions& options);

/// Returns the built-in methods, the methods of `method_libraries` and the learned baselines
/// (addGeneratorMethods()). Throws as methodsWith(). The weights of the baselines are loaded on
/// first use.
MethodRegistry loadMethods(const ModelOptions& options);

/// Returns a method of loadMethods() with loadPredictionModels(); name "" is the package's own
/// method (defaultMethod()). Throws as these functions, and std::invalid_argument as MethodMaker
/// for an unknown name or a method without a model that it needs.
MethodMaker loadMethod(const std::string& name, const ModelOptions& models,
                       const AttackOptions& attack);

}  // namespace forge
