#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/attack/network/foresight.h"
#include "collision_forge/attack/network/method_maker.h"
#include "collision_forge/attack/network/pattern_network.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// A file that holds no pattern networks, or damaged ones. Names file, network and field.
struct PatternNetworkFileError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The networks of a file, the one for all scenes first. Each is a line of JSON (format,
/// left_out_scenes, features, network, and the name, outputs and inputs of every layer), then for
/// each layer its matrix row by row and its bias, 32-bit floats with the lowest byte first. Throws
/// PatternNetworkFileError for a file that is absent, cut short, or of another architecture.
std::vector<PatternWeights> readPatternWeights(const std::string& path);

/// Throws as AsideFile does.
void writePatternWeights(const std::vector<PatternWeights>& networks, const std::string& path);

/// The network of a file, with its folds; null when `path` is empty. Throws as
/// readPatternWeights().
std::shared_ptr<const PatternNetwork> loadPatternNetwork(const std::string& path);

/// This and the speeds of loadSpeedForecaster(), which throw.
Foresight loadForesight(const ModelOptions& options);

/// The methods that are built in, those of its libraries and of its generators. Throws as
/// methodsWith().
MethodRegistry loadMethods(const ModelOptions& options);

/// A method of loadMethods() with loadForesight(); an empty name is the suite's own. Throws as they
/// and MethodMaker do.
MethodMaker loadMethod(const std::string& name, const ModelOptions& models,
                       const AttackOptions& attack);

}  // namespace forge
