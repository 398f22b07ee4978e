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

/// A learned traffic model from which its method is made. Thread-safe.
class TrafficMethods {
 public:
  virtual ~TrafficMethods() = default;

  /// Returns the method, with weights trained without the scene `unseen_scene`; with the first
  /// weights, trained on all scenes, if it is "" or all were trained with it. Called by the
  /// registry's factory, on the caller's thread, once per method and scene under test; may throw
  /// TrafficGeneratorError.
  virtual std::unique_ptr<const AttackMethod> method(const AttackOptions& options,
                                                     const std::string& unseen_scene) const = 0;
};

/// Registers the learned baselines c_mid, c_sgan, c_strive and published_network, methods with the
/// names of their models. A model's weights (generatorWeights()) and the library with libtorch are
/// loaded when its first method is made; that throws std::invalid_argument for a model without a
/// file, ConfigError and TrafficGeneratorError.
void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry);

/// Returns true for a method of addGeneratorMethods(). `method`: name in the registry.
bool isLearnedBaseline(const std::string& method);

}  // namespace forge

/// Loads a model's files into `methods`: the first was trained on all scenes, the others without
/// some of them. Implemented in the library that links libtorch (libcollision_forge_training.so),
/// and looked up there by this name. Throws forge::TrafficGeneratorError. `name`: the method's name
/// in the registry; `paths`: not empty.
extern "C" void forgeLoadGenerator(const std::string& name, const std::vector<std::string>& paths,
                                   std::shared_ptr<const forge::TrafficMethods>& methods);
