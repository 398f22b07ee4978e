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

/// Predictors that a method may use; never null.
struct MethodPredictors {
  std::shared_ptr<const EgoFutureSampler> ego_futures;  ///< samples futures of the ego
  std::shared_ptr<const PatternPredictor> patterns;     ///< predicts collision patterns
};

/// Input of a method's factory.
struct MethodSetup {
  AttackOptions options;
  MethodPredictors kinematic;                ///< without learned models
  std::optional<MethodPredictors> networks;  ///< with trained networks; empty if there are none
  /// name of the scene that models must not have been trained on; empty: none
  std::string unseen_scene;
};

/// The available methods by name. Extension point: a shared library adds methods, see
/// methodsWith(). Not thread-safe while methods are added.
class MethodRegistry {
 public:
  /// Makes a method. Called on the caller's thread once per method and scene under test, and by
  /// MethodMaker once to check the setup. Throws std::invalid_argument if `setup` lacks a required
  /// input; must not keep references to `setup`.
  using Make = std::function<std::unique_ptr<const AttackMethod>(const MethodSetup&)>;

  /// A method: `name` is unique, `description` is one line for people; `is_seeded` is true if
  /// results depend on the request's seed.
  struct Entry {
    std::string name;
    std::string description;
    bool is_seeded = true;
    Make make;
  };

  /// Appends a method. Throws std::invalid_argument if the name is empty or already used.
  void add(Entry entry);

  /// Returns all methods in the order of add().
  const std::vector<Entry>& entries() const { return entries_; }
  /// Returns the names in the order of add().
  std::vector<std::string> names() const;
  /// Returns true if a method has this name.
  bool has(const std::string& name) const;

  /// Returns the entry of a name, valid until the next add(). Throws std::invalid_argument for an
  /// unknown name, listing the known ones.
  const Entry& at(const std::string& name) const;

 private:
  std::vector<Entry> entries_;
};

/// Returns "search" and "network+search" (SearchMethod), "network" (PatternQuinticMethod),
/// "constant_velocity" and "nominal", in this order. The methods with "network" in their name need
/// MethodSetup::networks; only the first two are seeded.
MethodRegistry builtInMethods();

/// Returns the default method's name: "network+search" with networks, else "search".
std::string defaultMethod(bool has_networks);

/// Returns "network+" followed by `method`, the name of the method with trained networks.
std::string withNetworks(const std::string& method);
/// Returns the name without the prefix of withNetworks(); a name without it unchanged.
std::string withoutNetworks(const std::string& method);

/// Returns the setup's networks; throws std::invalid_argument if there are none.
const MethodPredictors& networksOf(const MethodSetup& setup);

/// Returns the built-in methods and the ones of shared libraries (paths, as for dlopen()). Each
/// library exports `extern "C" void addCollisionForgeMethods(forge::MethodRegistry&)`, called once
/// after loading; libraries stay loaded. Throws std::runtime_error, naming the library, if one
/// cannot be loaded or lacks the function, and as MethodRegistry::add() for a name that is used
/// already.
MethodRegistry methodsWith(const std::vector<std::string>& libraries);

}  // namespace forge
