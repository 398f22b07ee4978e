#include "collision_forge/attack/search/method_registry.h"

#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "collision_forge/attack/search/baselines.h"
#include "collision_forge/attack/search/search_method.h"

namespace forge {
namespace {

const std::string kNetwork = "network";
const std::string kSearch = "search";

void addMethodsOf(const std::string& library, MethodRegistry& registry) {
  void* handle = ::dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!handle) throw std::runtime_error("methods: " + std::string(::dlerror()));
  const char* const name = "addCollisionForgeMethods";
  auto* const add = reinterpret_cast<void (*)(MethodRegistry&)>(::dlsym(handle, name));
  if (!add) throw std::runtime_error("methods: " + library + " has no function " + name);
  add(registry);
}

}  // namespace

void MethodRegistry::add(Entry entry) {
  if (entry.name.empty() || has(entry.name)) {
    throw std::invalid_argument("method \"" + entry.name + "\": the name is empty or already used");
  }
  entries_.push_back(std::move(entry));
}

std::vector<std::string> MethodRegistry::names() const {
  std::vector<std::string> names;
  for (const Entry& entry : entries_) names.push_back(entry.name);
  return names;
}

bool MethodRegistry::has(const std::string& name) const {
  return std::any_of(entries_.begin(), entries_.end(),
                     [&](const Entry& entry) { return entry.name == name; });
}

const MethodRegistry::Entry& MethodRegistry::at(const std::string& name) const {
  std::string known;
  for (const Entry& entry : entries_) {
    if (entry.name == name) return entry;
    known += (known.empty() ? "" : ", ") + entry.name;
  }
  throw std::invalid_argument("method \"" + name + "\" is none of " + known);
}

MethodRegistry builtInMethods() {
  MethodRegistry registry;
  registry.add({kSearch, "patterns of the kinematic predictor, realised by the search", true,
                [](const MethodSetup& setup) {
                  return std::make_unique<SearchMethod>(setup.options, setup.kinematic.patterns);
                }});
  registry.add({withNetworks(kSearch), "patterns of the networks, realised by the search", true,
                [](const MethodSetup& setup) {
                  return std::make_unique<SearchMethod>(setup.options, networksOf(setup).patterns);
                }});
  registry.add({kNetwork, "one quintic to the likeliest pattern of the networks, as in the paper",
                false, [](const MethodSetup& setup) {
                  return std::make_unique<PatternQuinticMethod>(setup.options,
                                                                networksOf(setup).patterns);
                }});
  registry.add({"constant_velocity", "baseline: the attacker keeps its speed and heading", false,
                [](const MethodSetup& setup) {
                  return std::make_unique<ConstantVelocityMethod>(setup.options);
                }});
  registry.add(
      {"nominal", "baseline: one quintic to COLLIDE's nominal pose of the type", false,
       [](const MethodSetup& setup) { return std::make_unique<NominalMethod>(setup.options); }});
  return registry;
}

std::string defaultMethod(bool has_networks) {
  return has_networks ? withNetworks(kSearch) : kSearch;
}

std::string withNetworks(const std::string& method) { return kNetwork + "+" + method; }

std::string withoutNetworks(const std::string& method) {
  const std::string prefix = withNetworks("");
  return method.rfind(prefix, 0) == 0 ? method.substr(prefix.size()) : method;
}

const MethodForesight& networksOf(const MethodSetup& setup) {
  if (!setup.networks) {
    throw std::invalid_argument(
        "no pattern network: models.yaml names no file for pattern_network, or "
        "models.non_commercial_weights is false");
  }
  return *setup.networks;
}

MethodRegistry methodsWith(const std::vector<std::string>& libraries) {
  MethodRegistry registry = builtInMethods();
  for (const std::string& library : libraries) addMethodsOf(library, registry);
  return registry;
}

}  // namespace forge
