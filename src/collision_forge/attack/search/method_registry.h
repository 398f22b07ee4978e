#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "collision_forge/attack/search/attack_method.h"
#include "collision_forge/attack/search/options.h"
#include "collision_forge/attack/search/pattern_predictor.h"

namespace forge {

/// What a method foresees by.
struct MethodForesight {
  std::shared_ptr<const EgoFutureSampler> ego_futures;
  std::shared_ptr<const PatternPredictor> patterns;
};

/// What methods are made of.
struct MethodSetup {
  AttackOptions options;
  MethodForesight kinematic;                ///< without learning
  std::optional<MethodForesight> networks;  ///< by trained networks, where there are any
  std::string unseen_scene;  ///< that nothing may have been learned from; empty: none
};

/// The methods that there are, by name.
class MethodRegistry {
 public:
  /// May throw std::invalid_argument for a setup that lacks what the method needs.
  using Make = std::function<std::unique_ptr<const AttackMethod>(const MethodSetup&)>;

  /// One line about the method, for people, and whether its answers depend on the request's seed.
  struct Entry {
    std::string name;
    std::string description;
    bool is_seeded = true;
    Make make;
  };

  /// Throws std::invalid_argument for a name that is empty or taken.
  void add(Entry entry);

  /// In the order in which they were added.
  const std::vector<Entry>& entries() const { return entries_; }
  std::vector<std::string> names() const;
  bool has(const std::string& name) const;

  /// Throws std::invalid_argument for an unknown name, naming the known ones.
  const Entry& at(const std::string& name) const;

 private:
  std::vector<Entry> entries_;
};

/// "search" and "network+search" (SearchMethod), "network" (PatternQuinticMethod),
/// "constant_velocity" and "nominal".
MethodRegistry builtInMethods();

/// The name of the suite's own method: with networks where there are any.
std::string defaultMethod(bool has_networks);

/// "network+METHOD": the name of the same method with trained networks, and back.
std::string withNetworks(const std::string& method);
std::string withoutNetworks(const std::string& method);

/// The setup's networks; throws std::invalid_argument where there are none.
const MethodForesight& networksOf(const MethodSetup& setup);

/// The built-in methods and those of shared libraries, which each export
/// `extern "C" void addCollisionForgeMethods(forge::MethodRegistry&)`. The libraries stay loaded.
/// Throws std::runtime_error, naming the library, for one that cannot be loaded.
MethodRegistry methodsWith(const std::vector<std::string>& libraries);

}  // namespace forge
