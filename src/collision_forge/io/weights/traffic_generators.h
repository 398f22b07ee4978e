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

/// Adds the methods of each of `options.generator_weights`. A model is loaded when a method is
/// first made of it, and the library with libtorch along with it; making throws
/// std::invalid_argument for one without a file, and TrafficGeneratorError.
void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry);

}  // namespace forge

/// Reads a model's files into `methods`: the first one learned from all scenes, others left some
/// out. In the library that brings libtorch along, found there by this name. Throws
/// forge::TrafficGeneratorError.
extern "C" void forgeLoadGenerator(const std::string& name, const std::vector<std::string>& paths,
                                   std::shared_ptr<const forge::TrafficMethods>& methods);
