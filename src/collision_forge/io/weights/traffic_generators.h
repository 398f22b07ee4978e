#pragma once

#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "collision_forge/attack/search/method_registry.h"
#include "collision_forge/io/logs/options.h"

namespace forge {

/// A file of a learned generator of traffic that cannot be used. Names the file and what is wrong.
struct TrafficGeneratorError : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// A learned model of traffic, from which methods are made. May be used from many threads.
class TrafficMethods {
 public:
  virtual ~TrafficMethods() = default;

  /// By the weights that left `unseen_scene` out; by the first ones where none did.
  virtual std::unique_ptr<const AttackMethod> method(const std::string& name,
                                                     const AttackOptions& options,
                                                     const std::string& unseen_scene) const = 0;
};

/// Adds the methods of the learned baselines. The weights of a model are looked up
/// (generatorWeights()) and loaded when a method is first made of it, and the library with libtorch
/// along with them; making throws std::invalid_argument for a model without a file, ConfigError and
/// TrafficGeneratorError.
void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry);

/// The model whose weights a method needs; "" for a method of no learned baseline.
std::string generatorOf(const std::string& method);

}  // namespace forge

/// Reads a model's files into `methods`: the first one learned from all scenes, others left some
/// out. In the library that brings libtorch along, found there by this name. Throws
/// forge::TrafficGeneratorError.
extern "C" void forgeLoadGenerator(const std::string& name, const std::vector<std::string>& paths,
                                   std::shared_ptr<const forge::TrafficMethods>& methods);
