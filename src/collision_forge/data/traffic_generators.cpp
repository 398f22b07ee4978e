#include "collision_forge/data/traffic_generators.h"

#include <dlfcn.h>

#include <mutex>

namespace forge {
namespace {

using Load = decltype(&forgeLoadGenerator);

/// libtorch takes seconds to load, which who asks for no generator need not wait for.
Load loader() {
  void* library = ::dlopen("libcollision_forge_training.so", RTLD_NOW);
  if (!library)
    throw TrafficGeneratorError(std::string("this build has no libtorch: ") + dlerror());
  void* function = ::dlsym(library, "forgeLoadGenerator");
  if (!function) throw TrafficGeneratorError(dlerror());
  return reinterpret_cast<Load>(function);
}

/// A generator that is loaded once, by whoever needs it first.
class LazyGenerator {
 public:
  LazyGenerator(std::string name, std::string path)
      : name_(std::move(name)), path_(std::move(path)) {}

  const TrafficMethods& get() {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (path_.empty()) {
      throw std::invalid_argument("generator_weights: " + name_ + " in models.yaml names no file");
    }
    if (!loaded_) loaded_ = loader()(name_, path_);
    return *loaded_;
  }

 private:
  std::string name_;
  std::string path_;
  std::mutex mutex_;
  std::shared_ptr<const TrafficMethods> loaded_;
};

std::string descriptionOf(const std::string& name) {
  if (name == "c_sgan") return "rival: Social-GAN, told type and TTA, as the paper compares with";
  return "a learned generator of traffic";
}

}  // namespace

void addGeneratorMethods(const ModelOptions& options, MethodRegistry& registry) {
  for (const auto& [name, path] : options.generator_weights) {
    const auto generator = std::make_shared<LazyGenerator>(name, path);
    registry.add({name, descriptionOf(name), true, [generator](const MethodSetup& setup) {
                    return generator->get().method(setup.options);
                  }});
  }
}

}  // namespace forge
