#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// Thrown if the weights of a learned traffic model cannot be used. Names the file and the problem.
struct TrafficGeneratorError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A learned traffic model from which methods are made. Thread-safe.
class TrafficMethods {
 public:
  virtual ~TrafficMethods() = default;

  /// Makes the method `name`, with weights trained without `unseen_scene`; with the first weights
  /// if all were trained with it.
  virtual std::unique_ptr<const AttackMethod> method(const std::string& name,
                                                     const AttackOptions& options,
                                                     const std::string& unseen_scene) const = 0;
};

/// Registers the methods of the learned baselines. A model's weights (generatorWeights()) and the
/// library with libtorch are loaded when the first method of the model is made; that throws
/// std::invalid_argument for a model without a file, ConfigError and TrafficGeneratorError.
void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry);

/// Returns the name of the model whose weights a method needs; "" if it is not a learned baseline.
std::string generatorOf(const std::string& method);

}  // namespace forge

/// Loads a model's files into `methods`: the first was trained on all scenes, the others without
/// some of them. Implemented in the library that links libtorch, and looked up there by this name.
/// Throws forge::TrafficGeneratorError.
extern "C" void forgeLoadGenerator(const std::string& name, const std::vector<std::string>& paths,
                                   std::shared_ptr<const forge::TrafficMethods>& methods);
