#include "collision_forge/io/weights/traffic_generators.h"

#include <dlfcn.h>

#include <mutex>

namespace forge {
namespace {

using Load = decltype(&forgeLoadGenerator);

/// Loads the library on first use: libtorch takes seconds to load.
Load loader() {
  void* library = ::dlopen("libcollision_forge_training.so", RTLD_NOW);
  if (!library)
    throw TrafficGeneratorError(std::string("this build has no libtorch: ") + dlerror());
  void* function = ::dlsym(library, "forgeLoadGenerator");
  if (!function) throw TrafficGeneratorError(dlerror());
  return reinterpret_cast<Load>(function);
}

/// A model that is loaded once, on first use.
class LazyModel {
 public:
  LazyModel(std::string name, ModelOptions options)
      : name_(std::move(name)), options_(std::move(options)) {}

  const TrafficMethods& get() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!loaded_) load();
    return *loaded_;
  }

 private:
  void load() {
    const std::vector<std::string> paths = generatorWeights(options_)[name_];
    if (!paths.empty()) return loader()(name_, paths, loaded_);
    throw std::invalid_argument(
        name_ +
        (options_.non_commercial_weights
             ? std::string(" has no file in study/generator_weights.yaml")
             : " needs weights that " + std::string(kNonCommercialKey) + ": false excludes"));
  }

  std::string name_;
  ModelOptions options_;
  std::mutex mutex_;
  std::shared_ptr<const TrafficMethods> loaded_;
};

/// A learned model and the method that runs on it, which has its name.
struct LearnedMethod {
  const char* name;
  const char* description;
};

constexpr LearnedMethod kMethods[] = {
    {"c_mid", "baseline: MID, a diffusion model, given type and TTA"},
    {"c_sgan", "baseline: Social-GAN, given type and TTA, as in the paper"},
    {"c_strive", "baseline: STRIVE's traffic model, given type and TTA"},
    {"published_network", "the paper's network as published, region proposal, one quintic"},
};

}  // namespace

void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry) {
  for (const LearnedMethod& method : kMethods) {
    const auto model = std::make_shared<LazyModel>(method.name, options);
    registry.add({method.name, method.description, true, [model](const MethodSetup& setup) {
                    return model->get().method(setup.options, setup.unseen_scene);
                  }});
  }
}

bool isLearnedBaseline(const std::string& method) {
  return std::any_of(std::begin(kMethods), std::end(kMethods),
                     [&](const LearnedMethod& known) { return method == known.name; });
}

}  // namespace forge
