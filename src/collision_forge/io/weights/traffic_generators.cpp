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

/// A method that runs on a learned model.
struct LearnedMethod {
  const char* model;
  const char* name;
  const char* description;
};

constexpr LearnedMethod kMethods[] = {
    {"c_mid", "c_mid", "baseline: MID, a diffusion model, given type and TTA"},
    {"c_sgan", "c_sgan", "baseline: Social-GAN, given type and TTA, as in the paper"},
    {"c_strive", "c_strive", "baseline: STRIVE's traffic model, given type and TTA"},
    {"c_strive", "strive_optimised",
     "baseline: STRIVE's search in the latent space for the request"},
    {"published_network", "published_network",
     "the paper's network as published, region proposal, one quintic"},
    {"published_network_regression", "published_network_regression",
     "the same with the regression of the ego's position"},
    {"published_network_target_points", "published_network_target_points",
     "the same with the ranking of target points"},
};

}  // namespace

void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry) {
  std::map<std::string, std::shared_ptr<LazyModel>> models;
  for (const LearnedMethod& method : kMethods) {
    std::shared_ptr<LazyModel>& model = models[method.model];
    if (!model) model = std::make_shared<LazyModel>(method.model, options);
    registry.add({method.name, method.description, true, [model, method](const MethodSetup& setup) {
                    return model->get().method(method.name, setup.options, setup.unseen_scene);
                  }});
  }
}

std::string generatorOf(const std::string& method) {
  for (const LearnedMethod& known : kMethods) {
    if (method == known.name) return known.model;
  }
  return "";
}

}  // namespace forge
